#include "render-gl/color.h"

#include <string.h>

#include "base/text.h"
#include "image/image.h"

static int digit(char c)
{
    static const char digits[] = "0123456789abcdef0123456789ABCDEF";
    const char *at = c ? strchr(digits, c) : NULL;
    return at ? (int)((at - digits) % 16) : -1;
}

bool color_parse(const char *text, float rgb[3])
{
    static const char *const names[][2] = {{"black", "#000"},     {"white", "#fff"},
                                           {"grey", "#808080"},   {"gray", "#808080"},
                                           {"cream", "#f7f0dd"},  {"sepia", "#4b2e18"},
                                           {"blue", "#1f3a6e"},   {"red", "#8c1c13"}};
    for (size_t i = 0; i < sizeof names / sizeof *names; i++)
        if (strcmp(text, names[i][0]) == 0)
            text = names[i][1];
    size_t length = strlen(text), each = length == 7 ? 2 : 1;
    if (text[0] != '#' || (length != 4 && length != 7))
        return false;
    for (size_t c = 0; c < 3; c++) {
        int high = digit(text[1 + c * each]), low = digit(text[c * each + each]);
        if (high < 0 || low < 0)
            return false;
        rgb[c] = hatch_srgb_to_linear((float)(16 * high + low) / 255.0f);
    }
    return true;
}

bool vector_parse(const char *text, double xyz[3])
{
    for (int k = 0; k < 3; k++) {
        size_t length = strcspn(text, ",");
        if (!hatch_text_number((struct hatch_text){text, length}, &xyz[k]))
            return false;
        text += length;
        if (*text != (k < 2 ? ',' : '\0'))
            return false;
        text += k < 2;
    }
    return true;
}
