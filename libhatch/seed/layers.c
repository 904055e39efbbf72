#include "seed/layers.h"

#include <string.h>

#include "base/settings.h"

#define RADIANS (3.14159265358979324 / 180)

/* Parses "LOW..HIGH". */
static enum hatch_status parse_tone(struct hatch_text word, struct hatch_layer_line *line, struct hatch_err *err)
{
    struct hatch_text low = word, high = {word.at, 0};
    for (size_t i = 0; i + 1 < word.length && !high.length; i++)
        if (word.at[i] == '.' && word.at[i + 1] == '.') {
            low.length = i;
            high = (struct hatch_text){word.at + i + 2, word.length - i - 2};
        }
    if (!high.length)
        return hatch_fail(err, HATCH_BAD_INPUT, "tone: '%.*s', want FROM..TO, like 0.2..0.6",
                          hatch_settings_shown(word), word.at);
    HATCH_TRY(hatch_settings_number(low, "tone", 0, 1, &line->low, err));
    HATCH_TRY(hatch_settings_number(high, "tone", 0, 1, &line->high, err));
    if (!(line->low < line->high))
        return hatch_fail(err, HATCH_BAD_INPUT, "tone: the range from %g to %g is empty", line->low, line->high);
    line->tone_given = true;
    return HATCH_OK;
}

/* Parses the name of a stroke. It is the whole rest of the line, because file names may contain spaces. */
static enum hatch_status parse_stroke(struct hatch_text *rest, struct hatch_arena *arena, struct hatch_layer_line *line,
                                      struct hatch_err *err)
{
    struct hatch_text name = *rest;
    while (name.length && (name.at[0] == ' ' || name.at[0] == '\t')) {
        name.at++;
        name.length--;
    }
    while (name.length && (name.at[name.length - 1] == ' ' || name.at[name.length - 1] == '\t'))
        name.length--;
    if (!name.length || memchr(name.at, '\0', name.length))
        return hatch_fail(err, HATCH_BAD_INPUT, "stroke: want the name of a brush or a file");
    line->stroke = hatch_arena_text(arena, name.at, name.length, err);
    rest->length = 0;
    return line->stroke ? HATCH_OK : HATCH_LIMIT;
}

/* Keys with one number. */
static const struct {
    const char *name;
    double low, high;
    size_t offset; /* in struct hatch_layer_line */
} number_keys[] = {
    {"length", 0.5, 4096, offsetof(struct hatch_layer_line, length_px)},
    {"width", 0.5, 4096, offsetof(struct hatch_layer_line, width_px)},
    {"ink", 0.01, 1, offsetof(struct hatch_layer_line, ink)},
    {"tile", 8, 8192, offsetof(struct hatch_layer_line, tile_px)},
};
enum { NUMBER_KEYS = sizeof number_keys / sizeof *number_keys };

static enum hatch_status parse_key(struct hatch_text key, struct hatch_text *rest, struct hatch_arena *arena,
                                   struct hatch_layer_line *line, struct hatch_err *err)
{
    struct hatch_text word;
    if (hatch_text_is(key, "stroke"))
        return parse_stroke(rest, arena, line, err);
    size_t i = 0;
    while (i < NUMBER_KEYS && !hatch_text_is(key, number_keys[i].name))
        i++;
    bool tone = hatch_text_is(key, "tone"), turn = hatch_text_is(key, "turn");
    if (i == NUMBER_KEYS && !tone && !turn)
        return hatch_fail(err, HATCH_BAD_INPUT,
                          "no such key '%.*s': want length, width, ink, tile, tone, turn or stroke",
                          hatch_settings_shown(key), key.at);
    double *number = i < NUMBER_KEYS ? (double *)(void *)((char *)line + number_keys[i].offset) : NULL;
    if ((tone && line->tone_given) || (turn && line->turn_given) || (number && *number > 0))
        return hatch_fail(err, HATCH_BAD_INPUT, "%.*s is repeated", hatch_settings_shown(key), key.at);
    if (!hatch_text_word(rest, &word))
        return hatch_fail(err, HATCH_BAD_INPUT, "%.*s: a value is missing", hatch_settings_shown(key), key.at);
    if (tone)
        return parse_tone(word, line, err);
    if (number)
        return hatch_settings_number(word, number_keys[i].name, number_keys[i].low, number_keys[i].high, number, err);
    HATCH_TRY(hatch_settings_number(word, "turn", -360, 360, &line->turn_rad, err));
    line->turn_rad *= RADIANS;
    line->turn_given = true;
    return HATCH_OK;
}

enum hatch_status hatch_layers_read(struct hatch_bytes file, struct hatch_arena *arena, struct hatch_layers *layers,
                                    struct hatch_err *err)
{
    struct hatch_text rest = hatch_text_of(file), line, key;
    struct hatch_layers found = {0};
    HATCH_TRY(HATCH_ALLOC(arena, &found.lines, HATCH_RPTAM_LAYERS_MAX, err));
    for (uint32_t number = 1; hatch_settings_line(&rest, &line); number++) {
        bool begun = false;
        while (hatch_text_word(&line, &key)) {
            if (!begun && found.count == HATCH_RPTAM_LAYERS_MAX)
                return hatch_fail(err, HATCH_LIMIT, "line %u: more than %u layers", number, HATCH_RPTAM_LAYERS_MAX);
            found.count += !begun;
            begun = true;
            enum hatch_status status = parse_key(key, &line, arena, &found.lines[found.count - 1], err);
            if (status == HATCH_BAD_INPUT)
                return hatch_fail_at(err, "line %u: ", number);
            HATCH_TRY(status);
        }
    }
    if (!found.count)
        return hatch_fail(err, HATCH_BAD_INPUT, "the file has no layer");
    *layers = found;
    return HATCH_OK;
}
