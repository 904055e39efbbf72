#include "stroke/script.h"

#include <string.h>

#include "base/text.h"
#include "stroke/path.h"

enum { X, Y, LENGTH, ANGLE, WIDTH, TONE, RED, GREEN, BLUE, REQUIRED };
enum { BEND = REQUIRED, ID, COLUMN, LEVEL, GRAIN, NUMBERS };
enum { ENTERS = NUMBERS, PATH, KEYS };

static const struct {
    const char *name;
    double low, high;
} keys[KEYS] = {
    [X] = {"x", -1e6, 1e6},
    [Y] = {"y", -1e6, 1e6},
    [LENGTH] = {"length", 0, (double)HATCH_PATH_LENGTH_MAX},
    [ANGLE] = {"angle", -1e3, 1e3},
    [WIDTH] = {"width", 1e-30, HATCH_SCRIPT_WIDTH_MAX},
    [TONE] = {"tone", 0, 1},
    [RED] = {"r", 0, 1},
    [GREEN] = {"g", 0, 1},
    [BLUE] = {"b", 0, 1},
    [ID] = {"id", 0, 16777216},
    [COLUMN] = {"column", 0, 255},
    [LEVEL] = {"level", 0, 31},
    [GRAIN] = {"grain", 0, 4294967295.0},
    [ENTERS] = {"enters", 0, 0},
    [PATH] = {"path", 0, 0},
    [BEND] = {"bend", -(double)HATCH_STROKE_BEND_MAX, (double)HATCH_STROKE_BEND_MAX},
};

/* Columns that are printed only when a stroke needs them. */
struct extras {
    bool bend, enters, path;
};

static struct extras find_extras(const struct hatch_stroke *strokes, uint32_t count)
{
    struct extras extras = {false, false, false};
    for (uint32_t i = 0; i < count; i++) {
        extras.bend |= strokes[i].bend_rad != 0;
        extras.path |= strokes[i].path != NULL;
        for (uint32_t level = 0; level < HATCH_STROKE_LEVELS_MAX; level++)
            extras.enters |= strokes[i].delay[level] != 0;
    }
    return extras;
}

static enum hatch_status print_header(const struct extras *extras, struct hatch_buffer *text, struct hatch_err *err)
{
    for (int k = 0; k < REQUIRED; k++)
        HATCH_TRY(hatch_buffer_print(text, err, "%s\t", keys[k].name));
    return hatch_buffer_print(text, err, "id\tcolumn\tlevel\tgrain%s%s%s\n", extras->bend ? "\tbend" : "",
                              extras->enters ? "\tenters" : "", extras->path ? "\tpath" : "");
}

static enum hatch_status print_extras(const struct hatch_stroke *s, const struct extras *extras,
                                      struct hatch_buffer *text, struct hatch_err *err)
{
    if (extras->bend)
        HATCH_TRY(hatch_buffer_print(text, err, "\t%.9g", (double)s->bend_rad));
    if (extras->enters && s->level >= HATCH_STROKE_LEVELS_MAX)
        HATCH_TRY(hatch_buffer_print(text, err, "\t"));
    for (uint32_t level = 0; extras->enters && level <= s->level && s->level < HATCH_STROKE_LEVELS_MAX; level++)
        HATCH_TRY(hatch_buffer_print(text, err, "%c%u", level ? ',' : '\t', s->column + s->delay[level]));
    if (extras->path && !s->path)
        HATCH_TRY(hatch_buffer_print(text, err, "\t"));
    for (uint32_t i = 0; s->path && i < s->path->count; i++)
        HATCH_TRY(hatch_buffer_print(text, err, "%c%.9g,%.9g", i ? ' ' : '\t', (double)s->path->xy[2 * i],
                                     (double)s->path->xy[2 * i + 1]));
    return hatch_buffer_print(text, err, "\n");
}

enum hatch_status hatch_script_print(const struct hatch_stroke *strokes, uint32_t count, uint32_t size_px,
                                     const char *comment, struct hatch_buffer *text, struct hatch_err *err)
{
    struct extras extras = find_extras(strokes, count);
    if (comment)
        HATCH_TRY(hatch_buffer_print(text, err, "# %s\n", comment));
    HATCH_TRY(print_header(&extras, text, err));
    for (uint32_t i = 0; i < count; i++) {
        const struct hatch_stroke *s = &strokes[i];
        HATCH_TRY(hatch_buffer_print(
            text, err, "%.9g\t%.9g\t%.9g\t%.9g\t%.9g\t%.9g\t%.9g\t%.9g\t%.9g\t%u\t%u\t%u\t%u", (double)s->x,
            (double)s->y, (double)s->length, (double)s->angle_rad, (double)s->width_px / size_px, (double)s->tone,
            (double)s->rgb[0], (double)s->rgb[1], (double)s->rgb[2], s->id, s->column, s->level, s->texture_seed));
        HATCH_TRY(print_extras(s, &extras, text, err));
    }
    return HATCH_OK;
}

struct header {
    int key_of[64]; /* key of each column; -1: unknown */
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
            return hatch_fail(err, HATCH_BAD_INPUT, "header: column '%s' is repeated", keys[key].name);
        if (key >= 0)
            seen[key] = true;
        header->key_of[header->columns++] = key;
    }
    for (int k = 0; k < REQUIRED; k++)
        if (!seen[k])
            return hatch_fail(err, HATCH_BAD_INPUT, "header: no column '%s'", keys[k].name);
    return HATCH_OK;
}

/* The fields of a line below the header. */
struct row {
    double numbers[NUMBERS];
    struct hatch_text enters, path;
};

static enum hatch_status parse_number(struct hatch_text field, int key, double *number, struct hatch_err *err)
{
    if (!hatch_text_number(field, number))
        return hatch_fail(err, HATCH_BAD_INPUT, "%s '%.*s' is not a number", keys[key].name,
                          (int)(field.length < 40 ? field.length : 40), field.at);
    if (!(*number >= keys[key].low && *number <= keys[key].high))
        return hatch_fail(err, HATCH_BAD_INPUT, "%s %g, want %g to %g", keys[key].name, *number, keys[key].low,
                          keys[key].high);
    if (key >= ID && *number != floor(*number))
        return hatch_fail(err, HATCH_BAD_INPUT, "%s %g, want a whole number", keys[key].name, *number);
    return HATCH_OK;
}

/* The length of a path follows from its points; its length column is for programs that do not read paths. */
static enum hatch_status check_length(const struct row *row, struct hatch_err *err)
{
    double length = row->numbers[LENGTH], longest = HATCH_LINE_LENGTH_MAX;
    if (row->path.length == 0 && length > longest)
        return hatch_fail(err, HATCH_BAD_INPUT, "length %g, want 0 to %g", length, longest);
    return HATCH_OK;
}

static enum hatch_status parse_row(struct hatch_text line, const struct header *header, struct row *row,
                                   struct hatch_err *err)
{
    struct hatch_text field;
    uint32_t column = 0;
    for (; hatch_text_field(&line, &field); column++) {
        int key = column < header->columns ? header->key_of[column] : -1;
        if (key == ENTERS)
            row->enters = field;
        else if (key == PATH)
            row->path = field;
        else if (key >= 0)
            HATCH_TRY(parse_number(field, key, &row->numbers[key], err));
    }
    if (column != header->columns)
        return hatch_fail(err, HATCH_BAD_INPUT, "%u field%s, want %u", column, column == 1 ? "" : "s", header->columns);
    return HATCH_OK;
}

/* Removes the text before the next separator from *rest, or all of it if there is none, and returns it. */
static struct hatch_text take_until(struct hatch_text *rest, char separator)
{
    const char *end = rest->length ? memchr(rest->at, separator, rest->length) : NULL;
    struct hatch_text taken = {rest->at, end ? (size_t)(end - rest->at) : rest->length};
    size_t passed = taken.length + (end != NULL);
    *rest = (struct hatch_text){rest->at + passed, rest->length - passed};
    return taken;
}

static enum hatch_status parse_enters(struct hatch_text rest, struct hatch_stroke *stroke, struct hatch_err *err)
{
    uint32_t levels = 0;
    for (; rest.length && levels < HATCH_STROKE_LEVELS_MAX; levels++) {
        double column;
        HATCH_TRY(parse_number(take_until(&rest, ','), COLUMN, &column, err));
        if (column < stroke->column + (levels ? stroke->delay[levels - 1] : 0.0))
            return hatch_fail(err, HATCH_BAD_INPUT,
                              "enters: the columns must begin at the stroke's column and never fall");
        stroke->delay[levels] = (uint8_t)(column - stroke->column);
    }
    if (rest.length || (levels && (levels != stroke->level + 1 || stroke->delay[0])))
        return hatch_fail(err, HATCH_BAD_INPUT, "enters: want %u columns, for levels 0 to %u, the first being %u",
                          stroke->level + 1u, (unsigned)stroke->level, (unsigned)stroke->column);
    return HATCH_OK;
}

static enum hatch_status parse_path(struct hatch_text rest, struct hatch_arena *arena, struct hatch_stroke *stroke,
                                    struct hatch_err *err)
{
    uint32_t count = 1;
    for (size_t i = 0; i < rest.length; i++)
        count += rest.at[i] == ' ' && count < UINT32_MAX;
    if (count < 2 || count > HATCH_PATH_POINTS_MAX)
        return hatch_fail(err, HATCH_BAD_INPUT, "path: %u points, want 2 to %u", count, HATCH_PATH_POINTS_MAX);
    struct hatch_path *path;
    float *xy;
    HATCH_TRY(HATCH_ALLOC(arena, &path, 1, err));
    HATCH_TRY(HATCH_ALLOC(arena, &xy, 2 * (size_t)count, err));
    for (uint32_t i = 0; i < 2 * count; i++) {
        double number;
        if (!hatch_text_number(take_until(&rest, i % 2 ? ' ' : ','), &number) ||
            !(fabs(number) <= HATCH_PATH_REACH_MAX))
            return hatch_fail(err, HATCH_BAD_INPUT, "path: point %u is not x,y within %g tiles", i / 2 + 1,
                              HATCH_PATH_REACH_MAX);
        xy[i] = (float)number;
    }
    *path = (struct hatch_path){count, xy};
    stroke->path = path;
    stroke->length = hatch_path_length(path);
    if (!(stroke->length <= HATCH_PATH_LENGTH_MAX))
        return hatch_fail(err, HATCH_BAD_INPUT, "path: %g tiles long, want %g at most", (double)stroke->length,
                          (double)HATCH_PATH_LENGTH_MAX);
    return HATCH_OK;
}

static struct hatch_stroke stroke_of(const double *v, uint32_t size_px)
{
    return (struct hatch_stroke){.x = hatch_stroke_wrap(v[X]),
                                 .y = hatch_stroke_wrap(v[Y]),
                                 .length = (float)v[LENGTH],
                                 .angle_rad = (float)v[ANGLE],
                                 .bend_rad = (float)v[BEND] + 0.0f, /* turns -0 into 0 */
                                 .width_px = (float)(v[WIDTH] * size_px),
                                 .tone = (float)v[TONE],
                                 .rgb = {(float)v[RED], (float)v[GREEN], (float)v[BLUE]},
                                 .id = (uint32_t)v[ID],
                                 .column = (uint32_t)v[COLUMN],
                                 .level = (uint32_t)v[LEVEL],
                                 .texture_seed = (uint32_t)v[GRAIN]};
}

static enum hatch_status parse_stroke(struct hatch_text line, const struct header *header, uint32_t size_px,
                                      struct hatch_arena *arena, struct hatch_stroke *stroke, struct hatch_err *err)
{
    struct row row = {.numbers = {0}};
    HATCH_TRY(parse_row(line, header, &row, err));
    *stroke = stroke_of(row.numbers, size_px);
    HATCH_TRY(parse_enters(row.enters, stroke, err));
    HATCH_TRY(check_length(&row, err));
    return row.path.length ? parse_path(row.path, arena, stroke, err) : HATCH_OK;
}

enum hatch_status hatch_script_parse(struct hatch_bytes text, uint32_t size_px, struct hatch_arena *arena,
                                     struct hatch_stroke_list *strokes, struct hatch_err *err)
{
    struct hatch_text rest = hatch_text_of(text), line;
    struct hatch_stroke_list list = {0};
    struct header header = {.columns = 0};
    for (uint32_t row = 1; hatch_text_line(&rest, &line); row++) {
        if (line.length == 0 || line.at[0] == '#')
            continue;
        if (header.columns == 0) {
            HATCH_TRY(parse_header(line, &header, err));
            continue;
        }
        struct hatch_stroke stroke;
        if (parse_stroke(line, &header, size_px, arena, &stroke, err) != HATCH_OK)
            return hatch_fail_at(err, "line %u: ", row);
        HATCH_TRY(hatch_stroke_list_add(&list, arena, &stroke, err));
    }
    if (header.columns == 0)
        return hatch_fail(err, HATCH_BAD_INPUT, "no header line");
    *strokes = list;
    return HATCH_OK;
}
