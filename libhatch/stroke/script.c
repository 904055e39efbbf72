#include "stroke/script.h"

#include <math.h>

#include "base/text.h"

enum { X, Y, LENGTH, ANGLE, WIDTH, TONE, RED, GREEN, BLUE, REQUIRED };
enum { ID = REQUIRED, COLUMN, LEVEL, GRAIN, KEYS };

static const struct {
    const char *name;
    double low, high;
} keys[KEYS] = {
    [X] = {"x", -1e6, 1e6},       [Y] = {"y", -1e6, 1e6},   [LENGTH] = {"length", 0, 16},
    [ANGLE] = {"angle", -1e3, 1e3}, [WIDTH] = {"width", 1e-9, 4}, [TONE] = {"tone", 0, 1},
    [RED] = {"r", 0, 1},          [GREEN] = {"g", 0, 1},    [BLUE] = {"b", 0, 1},
    [ID] = {"id", 0, 16777216},   [COLUMN] = {"column", 0, 255}, [LEVEL] = {"level", 0, 31},
    [GRAIN] = {"grain", 0, 4294967295.0},
};

enum hatch_status hatch_script_print(const struct hatch_stroke *strokes, uint32_t count,
                                     uint32_t size_px, const char *comment,
                                     struct hatch_buffer *text, struct hatch_err *err)
{
    if (comment)
        HATCH_TRY(hatch_buffer_print(text, err, "# %s\n", comment));
    for (int k = 0; k < KEYS; k++)
        HATCH_TRY(hatch_buffer_print(text, err, "%s%c", keys[k].name, k + 1 < KEYS ? '\t' : '\n'));
    for (uint32_t i = 0; i < count; i++) {
        const struct hatch_stroke *s = &strokes[i];
        HATCH_TRY(hatch_buffer_print(
            text, err, "%.9g\t%.9g\t%.9g\t%.9g\t%.9g\t%.9g\t%.9g\t%.9g\t%.9g\t%u\t%u\t%u\t%u\n",
            (double)s->x, (double)s->y, (double)s->length, (double)s->angle_rad,
            (double)s->width_px / size_px, (double)s->tone, (double)s->rgb[0], (double)s->rgb[1],
            (double)s->rgb[2], s->id, s->column, s->level, s->texture_seed));
    }
    return HATCH_OK;
}

/* Which key each column of the header line holds; -1 for one that is not known. */
struct header {
    int key_of[64];
    uint32_t columns;
};

static enum hatch_status parse_header(struct hatch_text line, struct header *header, struct hatch_err *err)
{
    bool seen[KEYS] = {false};
    struct hatch_text field;
    header->columns = 0;
    while (hatch_text_field(&line, &field)) {
        if (header->columns == 64)
            return hatch_fail(err, HATCH_BAD_INPUT, "header: more than 64 columns");
        int key = -1;
        for (int k = 0; k < KEYS; k++)
            if (hatch_text_is(field, keys[k].name))
                key = k;
        if (key >= 0 && seen[key])
            return hatch_fail(err, HATCH_BAD_INPUT, "header: column '%s' stands twice", keys[key].name);
        if (key >= 0)
            seen[key] = true;
        header->key_of[header->columns++] = key;
    }
    for (int k = 0; k < REQUIRED; k++)
        if (!seen[k])
            return hatch_fail(err, HATCH_BAD_INPUT, "header: no column '%s'", keys[k].name);
    return HATCH_OK;
}

static enum hatch_status parse_row(struct hatch_text line, const struct header *header, uint32_t row,
                                   double *values, struct hatch_err *err)
{
    struct hatch_text field;
    uint32_t column = 0;
    for (; hatch_text_field(&line, &field); column++) {
        int key = column < header->columns ? header->key_of[column] : -1;
        if (key < 0)
            continue;
        if (!hatch_text_number(field, &values[key]))
            return hatch_fail(err, HATCH_BAD_INPUT, "line %u: '%.*s' is not a number", row,
                              (int)(field.length < 40 ? field.length : 40), field.at);
        if (!(values[key] >= keys[key].low && values[key] <= keys[key].high))
            return hatch_fail(err, HATCH_BAD_INPUT, "line %u: %s %g, want %g to %g", row,
                              keys[key].name, values[key], keys[key].low, keys[key].high);
        if (key >= REQUIRED && values[key] != floor(values[key]))
            return hatch_fail(err, HATCH_BAD_INPUT, "line %u: %s %g, want a whole number", row,
                              keys[key].name, values[key]);
    }
    if (column != header->columns)
        return hatch_fail(err, HATCH_BAD_INPUT, "line %u: %u fields, want %u", row, column,
                          header->columns);
    return HATCH_OK;
}

/* A centre outside the tile is the same place inside it. */
static float wrap_unit(double x)
{
    float wrapped = (float)(x - floor(x));
    return wrapped < 1 ? wrapped : 0;
}

static struct hatch_stroke stroke_of(const double *v, uint32_t size_px)
{
    return (struct hatch_stroke){.x = wrap_unit(v[X]),
                                 .y = wrap_unit(v[Y]),
                                 .length = (float)v[LENGTH],
                                 .angle_rad = (float)v[ANGLE],
                                 .width_px = (float)(v[WIDTH] * size_px),
                                 .tone = (float)v[TONE],
                                 .rgb = {(float)v[RED], (float)v[GREEN], (float)v[BLUE]},
                                 .id = (uint32_t)v[ID],
                                 .column = (uint32_t)v[COLUMN],
                                 .level = (uint32_t)v[LEVEL],
                                 .texture_seed = (uint32_t)v[GRAIN]};
}

enum hatch_status hatch_script_parse(struct hatch_bytes text, uint32_t size_px,
                                     struct hatch_arena *arena, struct hatch_stroke_list *strokes,
                                     struct hatch_err *err)
{
    struct hatch_text rest = {(const char *)text.data, text.size}, line;
    struct hatch_stroke_list list = {0};
    struct header header = {.columns = 0};
    for (uint32_t row = 1; hatch_text_line(&rest, &line); row++) {
        if (line.length == 0 || line.at[0] == '#')
            continue;
        if (header.columns == 0) {
            HATCH_TRY(parse_header(line, &header, err));
            continue;
        }
        double values[KEYS] = {0};
        HATCH_TRY(parse_row(line, &header, row, values, err));
        struct hatch_stroke stroke = stroke_of(values, size_px);
        HATCH_TRY(hatch_stroke_list_add(&list, arena, &stroke, err));
    }
    if (header.columns == 0)
        return hatch_fail(err, HATCH_BAD_INPUT, "no header line");
    *strokes = list;
    return HATCH_OK;
}
