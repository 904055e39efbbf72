#include "render-gl/mode/parse_args.h"

#include <ctype.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "image/color.h"

void parse_color(const char *option, struct hatch_text text, float rgb[3])
{
    char what[32], word[64];
    if (hatch_color_parse(text, rgb))
        return;
    snprintf(what, sizeof what, "--%s", option);
    snprintf(word, sizeof word, "%.*s", (int)text.length, text.at);
    cmd_refuse_name(what, word, hatch_color_names, "#rrggbb");
}

bool parse_whole(const char *text, uint32_t most, uint32_t *value)
{
    uint64_t number = 0;
    for (const char *at = text; *at; at++) {
        if (*at < '0' || *at > '9' || number > most)
            return false;
        number = 10 * number + (uint64_t)(*at - '0');
    }
    *value = (uint32_t)number;
    return *text && number <= most;
}

bool parse_camera_place(const char *text, struct hatch_view_choice *view)
{
    size_t length = strcspn(text, ":");
    view->kind = HATCH_VIEW_EYE;
    view->has_target = text[length] == ':';
    const char *target = text + length + 1;
    return hatch_text_vector((struct hatch_text){text, length}, view->eye) &&
           (!view->has_target || hatch_text_vector((struct hatch_text){target, strlen(target)}, view->target));
}

#define WHOLE_LISTS 2 /* of the words below, those that stand alone */

const char *const line_kind_names[] = {"none", "all", "silhouettes", "creases", "boundaries", NULL};

uint32_t parse_line_kinds(const char *list)
{
    static const uint32_t kinds_of[] = {HATCH_LINES_NONE, HATCH_LINES_ALL, HATCH_LINES_SILHOUETTES, HATCH_LINES_CREASES,
                                        HATCH_LINES_BOUNDARIES};
    uint32_t kinds = HATCH_LINES_NONE;
    for (const char *at = list; *at; at += *at == ',') {
        size_t size_bytes = strcspn(at, ","), i = 0;
        while (i < 5 && (strlen(line_kind_names[i]) != size_bytes || strncmp(at, line_kind_names[i], size_bytes) != 0))
            i++;
        if (i == 5 || strcmp(at + size_bytes, ",") == 0 || (i < WHOLE_LISTS && size_bytes < strlen(list)))
            break;
        kinds |= kinds_of[i];
        at += size_bytes;
        if (!*at)
            return kinds;
    }
    cmd_usage("--lines %s: want none, all, or silhouettes, creases and boundaries separated by commas", list);
}

double parse_length(const char *option, const char *text, double least, double most)
{
    size_t length = strlen(text);
    double value;
    if (length > 2 && strcmp(text + length - 2, "mm") == 0)
        length -= 2;
    if (!hatch_text_number((struct hatch_text){text, length}, &value) || !(value >= least && value <= most))
        cmd_usage("--%s %s: want a length from %g to %g mm", option, text, least, most);
    return value;
}

bool parse_has_ending(const char *path, const char *ending)
{
    const char *dot = path ? strrchr(path, '.') : NULL;
    size_t i = 0;
    while (dot && dot[i + 1] && tolower((unsigned char)dot[i + 1]) == ending[i])
        i++;
    return dot && i > 0 && !dot[i + 1] && !ending[i];
}

/* Returns the end of a field that begins at a percent sign, or NULL if none begins there.
 *   width  out: digits to write at least */
static const char *end_of_field(const char *at, int *width)
{
    const char *end = at + 1 + strspn(at + 1, "0123456789");
    *width = atoi(at + 1);
    return *end == 'd' && end - at <= 3 ? end + 1 : NULL;
}

/* Returns the only field of a file name, or NULL if it has none, several, or a single percent sign elsewhere.
 *   width  out: as in end_of_field */
static const char *find_field(const char *pattern, int *width)
{
    const char *found = NULL;
    for (const char *at = pattern ? strchr(pattern, '%') : NULL; at; at = strchr(at, '%')) {
        int digits = 0;
        const char *end = at[1] == '%' ? at + 2 : end_of_field(at, &digits);
        if (!end || (at[1] != '%' && found))
            return NULL;
        if (at[1] != '%') {
            found = at;
            *width = digits;
        }
        at = end;
    }
    return found;
}

bool parse_has_frame(const char *pattern)
{
    int width;
    return find_field(pattern, &width) != NULL;
}

void parse_frame_name(const char *pattern, uint32_t number, char *name, size_t size_bytes)
{
    int width = 0;
    const char *field = find_field(pattern, &width);
    char digits[32];
    size_t count = 0, used = 0;
    for (uint32_t rest = number; rest || !count; rest /= 10)
        digits[count++] = (char)('0' + rest % 10);
    while ((int)count < width && count < sizeof digits)
        digits[count++] = '0';
    for (const char *c = pattern; *c && used + 1 < size_bytes; c++) {
        if (c != field) {
            name[used++] = *c;
            c += field && *c == '%'; /* the second of two */
            continue;
        }
        while (count && used + 1 < size_bytes)
            name[used++] = digits[--count];
        c = strchr(c, 'd');
    }
    name[used] = '\0';
}
