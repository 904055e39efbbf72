#include "render-gl/color.h"

#include <string.h>

#include "image/color.h"

bool color_parse(struct hatch_text text, float rgb[3])
{
    static const char *const names[][2] = {{"black", "#000"},     {"white", "#fff"},
                                           {"grey", "#808080"},   {"gray", "#808080"},
                                           {"cream", "#f7f0dd"},  {"sepia", "#4b2e18"},
                                           {"blue", "#1f3a6e"},   {"red", "#8c1c13"}};
    for (size_t i = 0; i < sizeof names / sizeof *names; i++)
        if (hatch_text_is(text, names[i][0]))
            text = (struct hatch_text){names[i][1], strlen(names[i][1])};
    if (text.length == 0 || text.at[0] != '#')
        return false;
    return hatch_color_from_hex((struct hatch_text){text.at + 1, text.length - 1}, rgb);
}

bool vector_parse(struct hatch_text text, double xyz[3])
{
    for (int k = 0; k < 3; k++) {
        const char *comma = memchr(text.at, ',', text.length);
        size_t length = comma ? (size_t)(comma - text.at) : text.length;
        if (!hatch_text_number((struct hatch_text){text.at, length}, &xyz[k]))
            return false;
        if (k == 2)
            return !comma;
        if (!comma)
            return false;
        text.length -= length + 1;
        text.at += length + 1;
    }
    return false;
}
