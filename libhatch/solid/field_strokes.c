/* Strokes: straight capsules, evenly scattered. A stroke of rank p, 0 .. 1, appears at tone p and grows to its width;
 * the value at a place is the tone at which the first stroke covers it. */
#include "solid/field.h"

#include <assert.h>

#include "base/random.h"
#include "solid/points.h"

#define CELLS_MAX 64u
#define UNCOVERED 4.0f /* value where no stroke is near */

enum { STREAM_TURN = 0x74757268, STREAM_FAMILY };

struct stroke {
    float middle[3], half[3]; /* half: from the middle to the end */
    float rank;
};

struct state {
    const struct hatch_solid_style *style;
    uint32_t count, cells;
    struct stroke *strokes;
    uint32_t *first; /* per cell, its first entry in list; cells^3 + 1 entries */
    uint32_t *list;  /* strokes near each cell */
    float reach;     /* distance from its axis within which a stroke has an effect */
};

/* Returns the squared distance of a place from the nearest copy of a stroke. Its length and reach are at most half a
 * side together, so that this is the copy whose middle is nearest. */
static float squared_distance(const struct stroke *stroke, const float at[3])
{
    float from[3], along = 0, length = 0, squared = 0;
    for (int i = 0; i < 3; i++) {
        from[i] = at[i] - stroke->middle[i];
        from[i] -= floorf(from[i] + 0.5f);
        along += from[i] * stroke->half[i];
        length += stroke->half[i] * stroke->half[i];
    }
    along = fminf(fmaxf(along / length, -1), 1);
    for (int i = 0; i < 3; i++) {
        float away = from[i] - along * stroke->half[i];
        squared += away * away;
    }
    return squared;
}

static float value(const void *context, const float at[3])
{
    const struct state *state = context;
    const struct hatch_solid_style *style = state->style;
    float least = UNCOVERED, radius = style->width / 2;
    uint32_t cell =
        (hatch_solid_cell(at[2], state->cells) * state->cells + hatch_solid_cell(at[1], state->cells)) * state->cells +
        hatch_solid_cell(at[0], state->cells);
    for (uint32_t i = state->first[cell]; i < state->first[cell + 1]; i++) {
        const struct stroke *stroke = &state->strokes[state->list[i]];
        /* A stroke grows fast to its width and slowly beyond it: with the fourth root of the tone. */
        float share = squared_distance(stroke, at) / (radius * radius),
              tone = stroke->rank + style->grow * share * share;
        least = fminf(least, tone);
    }
    return least;
}

/* Chooses one of the directions whose tones include that at which a stroke appears; without any, a random one.
 *   out  of length 1 */
static void choose_direction(const struct solid_job *job, const struct hatch_noise *noise, uint32_t number, float rank,
                             float out[3])
{
    const struct hatch_solid_style *style = job->style;
    /* Strokes up to this rank, at random places, cover about this share. */
    float tone = (float)(1 - exp((double)(-style->density * rank)));
    const struct hatch_solid_direction *fitting[HATCH_SOLID_DIRECTIONS_MAX], *chosen = NULL;
    uint32_t fitting_count = 0;
    for (uint32_t i = 0; i < style->direction_count; i++)
        if (tone >= style->directions[i].from && tone <= style->directions[i].to)
            fitting[fitting_count++] = &style->directions[i];
    if (fitting_count)
        chosen = fitting[hatch_random_u64(job->seed, STREAM_FAMILY, number) % fitting_count];
    const float *turn = noise->gradients[hatch_random_u64(job->seed, STREAM_TURN, number) % HATCH_NOISE_GRADIENTS];
    float degrees = style->jitter / 360, cosine = hatch_noise_cosine(degrees),
          sine = hatch_noise_cosine(0.25f - degrees);
    float length = 0, chosen_length = 0;
    for (int i = 0; i < 3 && chosen; i++)
        chosen_length += chosen->vector[i] * chosen->vector[i];
    for (int i = 0; i < 3; i++) {
        out[i] = chosen ? cosine * chosen->vector[i] / sqrtf(chosen_length) + sine * turn[i] : turn[i];
        length += out[i] * out[i];
    }
    for (int i = 0; i < 3; i++)
        out[i] /= sqrtf(length);
}

static enum hatch_status scatter(const struct solid_job *job, struct state *state, struct hatch_err *err)
{
    struct hatch_solid_points points;
    struct hatch_noise noise;
    hatch_noise_make(job->seed, &noise);
    HATCH_TRY(hatch_solid_points_spread(state->count, 0, job->seed, job->pool, job->arena, job->scratch, &points, err));
    HATCH_TRY(HATCH_ALLOC(job->arena, &state->strokes, state->count, err));
    for (uint32_t i = 0; i < state->count; i++) {
        struct stroke *stroke = &state->strokes[i];
        stroke->rank = (float)points.numbers[i] / (float)state->count;
        choose_direction(job, &noise, points.numbers[i], stroke->rank, stroke->half);
        for (int c = 0; c < 3; c++) {
            stroke->middle[c] = points.at[i][c];
            stroke->half[c] *= job->style->length / 2;
        }
    }
    return HATCH_OK;
}

/* Visits the cells that a stroke reaches: counts it in each, or, with a list, enters it. */
static void visit(struct state *state, uint32_t number, uint32_t *list)
{
    const struct stroke *stroke = &state->strokes[number];
    int32_t low[3], high[3], cells = (int32_t)state->cells;
    float side = 1 / (float)cells, near = state->reach + 0.8660255f * side; /* half a diagonal */
    for (int c = 0; c < 3; c++) {
        float extent = fabsf(stroke->half[c]) + state->reach;
        low[c] = (int32_t)floorf((stroke->middle[c] - extent) * (float)cells);
        high[c] = (int32_t)floorf((stroke->middle[c] + extent) * (float)cells);
        high[c] = high[c] < low[c] + cells ? high[c] : low[c] + cells - 1;
    }
    for (int32_t z = low[2]; z <= high[2]; z++)
        for (int32_t y = low[1]; y <= high[1]; y++)
            for (int32_t x = low[0]; x <= high[0]; x++) {
                const float middle[3] = {((float)x + 0.5f) * side, ((float)y + 0.5f) * side, ((float)z + 0.5f) * side};
                if (squared_distance(stroke, middle) > near * near)
                    continue;
                int32_t cell = ((z + cells) % cells * cells + (y + cells) % cells) * cells + (x + cells) % cells;
                if (list)
                    list[--state->first[cell]] = number;
                else
                    state->first[cell]++;
            }
}

static enum hatch_status list_cells(const struct solid_job *job, struct state *state, struct hatch_err *err)
{
    uint32_t cell_count = state->cells * state->cells * state->cells;
    HATCH_TRY(HATCH_ALLOC(job->arena, &state->first, (size_t)cell_count + 1, err));
    for (uint32_t i = 0; i < state->count; i++)
        visit(state, i, NULL);
    for (uint32_t cell = 1; cell <= cell_count; cell++)
        state->first[cell] += state->first[cell - 1];
    HATCH_TRY(HATCH_ALLOC(job->arena, &state->list, state->first[cell_count], err));
    for (uint32_t i = state->count; i-- > 0;)
        visit(state, i, state->list);
    return HATCH_OK;
}

enum hatch_status solid_strokes_field(const struct solid_job *job, struct solid_field *field, struct hatch_err *err)
{
    const struct hatch_solid_style *style = job->style;
    struct state *state;
    HATCH_TRY(HATCH_ALLOC(job->arena, &state, 1, err));
    float radius = style->width / 2, volume = 3.1415927f * radius * radius * (style->length + 4 * radius / 3);
    state->style = style;
    state->count = (uint32_t)ceilf(style->density / volume);
    /* Strokes grow until e^-12 of the places are uncovered. */
    state->reach = radius * fmaxf(1.2f, sqrtf(12 / style->density));
    state->cells = (uint32_t)(1 / state->reach);
    state->cells = state->cells < CELLS_MAX ? state->cells : CELLS_MAX;
    HATCH_TRY(scatter(job, state, err));
    HATCH_TRY(list_cells(job, state, err));
    *field = (struct solid_field){value, state};
    return HATCH_OK;
}
