#include "solid/make.h"

#include <math.h>

#include "solid/equalize.h"
#include "solid/field.h"
#include "solid/points.h"

#define BATCHES 64u /* after each of which progress is reported */

struct making {
    const struct hatch_solid_options *options;
    struct solid_field field;
    uint32_t first_row;   /* of the batch, counted over all slices */
    float *values;        /* of all texels */
    const uint8_t *ranks; /* of equalized values; NULL: they are not equalized */
    struct hatch_solid *solid;
};

static enum hatch_status prepare(const struct solid_job *job, struct solid_field *field, struct hatch_err *err)
{
    static enum hatch_status (*const fields[HATCH_SOLID_KINDS])(const struct solid_job *, struct solid_field *,
                                                                struct hatch_err *) = {
        [HATCH_SOLID_PERLIN] = solid_noise_field,    [HATCH_SOLID_TURBULENCE] = solid_noise_field,
        [HATCH_SOLID_WOOD] = solid_wood_field,       [HATCH_SOLID_MARBLE] = solid_noise_field,
        [HATCH_SOLID_WORLEY] = solid_points_field,   [HATCH_SOLID_STIPPLE] = solid_points_field,
        [HATCH_SOLID_STROKES] = solid_strokes_field, [HATCH_SOLID_PAPER] = solid_noise_field,
        [HATCH_SOLID_CANVAS] = solid_canvas_field,
    };
    return fields[job->style->kind](job, field, err);
}

static void fill_row(void *context, uint32_t task)
{
    const struct making *m = context;
    uint32_t size = m->options->size, row = m->first_row + task;
    float *values = m->values + (size_t)row * size, middle = 0.5f / (float)size;
    float at[3] = {0, (float)(row % size) / (float)size + middle, (float)(row / size) / (float)size + middle};
    for (uint32_t x = 0; x < size; x++) {
        at[0] = (float)x / (float)size + middle;
        values[x] = m->field.value(m->field.state, at);
    }
}

/* Turns the values of a slice into texels. */
static void fill_slice(void *context, uint32_t slice)
{
    const struct making *m = context;
    const struct hatch_solid_style *style = m->options->style;
    size_t count = (size_t)m->options->size * m->options->size, from = slice * count;
    for (size_t i = from; i < from + count; i++) {
        float value = m->ranks ? (float)m->ranks[i] / 255 : 0.5f + style->contrast * (m->values[i] - 0.5f), rgb[3];
        value = fminf(fmaxf(value, 0), 1);
        if (style->color_count == 0) {
            m->solid->texels[i] = hatch_unorm8(value);
            continue;
        }
        hatch_ramp_color(style->colors, style->color_count, value, rgb);
        for (int c = 0; c < 3; c++)
            m->solid->texels[3 * i + (size_t)c] = hatch_unorm8(rgb[c]);
    }
}

static enum hatch_status fill(struct making *m, const struct solid_job *job, struct hatch_err *err)
{
    const struct hatch_solid_options *options = m->options;
    uint32_t rows = options->size * options->size, batch = rows < BATCHES ? rows : rows / BATCHES;
    uint32_t count = rows * options->size;
    bool equalizes = hatch_solid_equalizes(options->style);
    HATCH_TRY(prepare(job, &m->field, err));
    /* One array for values and ranks: the arena would make a second one as large as the first. */
    HATCH_TRY(HATCH_ALLOC_UNSET(job->scratch, &m->values, equalizes ? count + count / sizeof(float) : count, err));
    for (m->first_row = 0; m->first_row < rows; m->first_row += batch) {
        double share = (double)m->first_row / rows;
        hatch_progress_report(options->progress, m->field.prepared + (1 - m->field.prepared) * share);
        hatch_parallel_for(options->pool, batch, fill_row, m);
    }
    if (equalizes) {
        uint8_t *ranks = (uint8_t *)(m->values + count);
        HATCH_TRY(hatch_equalize(m->values, count, options->pool, job->scratch, ranks, err));
        m->ranks = ranks;
    }
    hatch_parallel_for(options->pool, options->size, fill_slice, m);
    return HATCH_OK;
}

static enum hatch_status make(const struct hatch_solid_options *options, struct hatch_arena *scratch,
                              struct hatch_solid *solid, struct hatch_err *err)
{
    struct making m = {.options = options, .solid = solid};
    struct hatch_solid_style style = *options->style;
    hatch_solid_style_fit(&style, options->size);
    struct solid_job job = {&style, options->size, options->seed, options->pool, options->progress, scratch, scratch};
    return fill(&m, &job, err);
}

uint64_t hatch_solid_style_bytes(const struct hatch_solid_style *style, uint32_t size)
{
    struct hatch_solid_style fitted = *style;
    hatch_solid_style_fit(&fitted, size);
    double side = (double)(fitted.kind == HATCH_SOLID_WORLEY ? fitted.scale : fitted.dots);
    return fitted.kind == HATCH_SOLID_STROKES ? solid_strokes_bytes(&fitted)
                                              : HATCH_SOLID_POINT_BYTES * (uint64_t)(side * side * side);
}

enum hatch_status hatch_solid_from_style(const struct hatch_solid_options *options, struct hatch_arena *arena,
                                         struct hatch_arena *scratch, struct hatch_solid *solid, struct hatch_err *err)
{
    struct hatch_solid made;
    struct hatch_arena_mark mark = hatch_arena_mark(scratch);
    HATCH_TRY(hatch_solid_make(arena, options->size, options->style->color_count ? 3 : 1, &made, err));
    enum hatch_status status = make(options, scratch, &made, err);
    hatch_arena_rewind(scratch, mark);
    HATCH_TRY(status);
    made.isotropic = hatch_solid_is_isotropic(options->style);
    *solid = made;
    return HATCH_OK;
}
