/* Strokes: straight capsules, evenly scattered. A stroke of rank p, 0 .. 1, appears at tone p and grows to its width;
 * the value at a place is the tone at which the first stroke covers it. */
#include "solid/field.h"

#include <assert.h>

#include "base/random.h"
#include "solid/points.h"

#define CELLS_MAX 64u
#define LEVEL 1e-6f    /* half of a stroke that runs along a layer of cells, not across it */
#define SCATTERED 0.3  /* share of the work that scattering the strokes is taken for */
#define LISTED 0.2     /* that listing them in cells is taken for */
#define REPORTED 4096u /* strokes between two reports of progress */
#define UNCOVERED 4.0f /* value where no stroke is near */

enum { STREAM_TURN = 0x74757268, STREAM_FAMILY };

struct stroke {
    float middle[3], half[3]; /* half: from the middle to the end */
    float squared_half;       /* squared length of that */
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

/* Returns the whole number nearest to one of a few units; those that are .5 above one are rounded up. */
static float nearest_whole(float number)
{
    int32_t whole = (int32_t)(number + 0.5f);
    return (float)(whole - ((float)whole > number + 0.5f));
}

/* Returns the squared distance of a place from the nearest copy of a stroke. Its length and reach are at most half a
 * side together, so that this is the copy whose middle is nearest. */
static float squared_distance(const struct stroke *stroke, const float at[3])
{
    float from[3], along = 0, squared = 0;
    for (int i = 0; i < 3; i++) {
        from[i] = at[i] - stroke->middle[i];
        from[i] -= nearest_whole(from[i]);
        along += from[i] * stroke->half[i];
    }
    along /= stroke->squared_half;
    along = along < 1 ? along : 1;
    along = along > -1 ? along : -1;
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
        least = tone < least ? tone : least;
    }
    return least;
}

/* Returns the tone at which a stroke of a rank appears. Values are equalized: it is the share of places that strokes of
 * lower ranks cover by then, at random places. At a value v, the radius of a stroke of rank r is half its width
 * times ((v - r) / grow)^(1/4); its volume is integrated over r from 0 to v. */
static float tone_of(const struct hatch_solid_style *style, float rank)
{
    const double radius = (double)style->width / 2, caps = 4 * radius / 3, length = (double)style->length;
    const double grown = (double)rank / (double)style->grow;
    if (!hatch_solid_equalizes(style))
        return rank;
    double volume = (2.0 / 3 * length * sqrt(grown) + 4.0 / 7 * caps * pow(grown, 0.75)) / (length + caps);
    return (float)(1 - exp(-(double)style->density * (double)rank * volume));
}

/* Chooses one of the directions whose tones include that at which a stroke appears; without any, a random one.
 *   out  of length 1 */
static void choose_direction(const struct solid_job *job, const struct hatch_noise *noise, uint32_t number, float rank,
                             float out[3])
{
    const struct hatch_solid_style *style = job->style;
    const float tone = tone_of(style, rank);
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

/* A part of the work, whose share is reported as one of the whole work. */
struct phase {
    const struct hatch_progress *whole;
    double from, span; /* shares of the whole */
};

static void report_phase(void *context, double share)
{
    const struct phase *phase = context;
    hatch_progress_report(phase->whole, phase->from + share * phase->span);
}

static enum hatch_status scatter(const struct solid_job *job, struct state *state, struct hatch_err *err)
{
    struct hatch_solid_points points;
    struct hatch_noise noise;
    struct phase phase = {job->progress, 0, SCATTERED};
    const struct hatch_progress progress = {report_phase, &phase};
    hatch_noise_make(job->seed, &noise);
    HATCH_TRY(hatch_solid_points_spread(state->count, 0, job->seed, job->pool, &progress, job->arena, job->scratch,
                                        &points, err));
    HATCH_TRY(HATCH_ALLOC(job->arena, &state->strokes, state->count, err));
    for (uint32_t i = 0; i < state->count; i++) {
        struct stroke *stroke = &state->strokes[i];
        stroke->rank = (float)points.numbers[i] / (float)state->count;
        choose_direction(job, &noise, points.numbers[i], stroke->rank, stroke->half);
        for (int c = 0; c < 3; c++) {
            stroke->middle[c] = points.at[i][c];
            stroke->half[c] *= job->style->length / 2;
            stroke->squared_half += stroke->half[c] * stroke->half[c];
        }
    }
    return HATCH_OK;
}

/* The cells that a stroke may reach. */
struct visit {
    const struct stroke *stroke;
    float near;    /* distance of the middle of a cell from the stroke within which the stroke reaches the cell */
    float beside;  /* a little more than that */
    int32_t cells; /* along a side */
    int32_t low[3], high[3]; /* those of the box around the stroke and its reach */
    bool wraps;              /* a cell of the box may be nearer to the stroke by way of another copy of it */
};

/* Shortens a part of a stroke, from part[0] to part[1] halves before and behind its middle, to that which lies beside a
 * layer of cells across an axis. Returns false if nothing is left. */
static bool cut_part(const struct visit *visit, int axis, int32_t cell, float part[2])
{
    float half = visit->stroke->half[axis];
    float from = ((float)cell + 0.5f) / (float)visit->cells - visit->stroke->middle[axis];
    if (visit->wraps)
        return true;
    if (fabsf(half) < LEVEL)
        return fabsf(from) <= visit->beside;
    float first = (from - visit->beside) / half, second = (from + visit->beside) / half;
    part[0] = fmaxf(part[0], fminf(first, second));
    part[1] = fminf(part[1], fmaxf(first, second));
    return part[0] <= part[1];
}

/* Finds the cells along an axis that lie beside a part of the stroke. */
static void bound_cells(const struct visit *visit, int axis, const float part[2], int32_t range[2])
{
    float half = visit->stroke->half[axis], first = part[0] * half, second = part[1] * half;
    float low = visit->stroke->middle[axis] + fminf(first, second) - visit->beside;
    float high = visit->stroke->middle[axis] + fmaxf(first, second) + visit->beside;
    int32_t low_cell = (int32_t)floorf(low * (float)visit->cells),
            high_cell = (int32_t)floorf(high * (float)visit->cells);
    bool within = !visit->wraps;
    range[0] = within && low_cell > visit->low[axis] ? low_cell : visit->low[axis];
    range[1] = within && high_cell < visit->high[axis] ? high_cell : visit->high[axis];
}

/* Returns the distance of the middle of a cell from a stroke within which the stroke may reach the cell. */
static float near_of(const struct state *state)
{
    return state->reach + 0.8660255f * (1 / (float)state->cells); /* half a diagonal */
}

/* Finds the box of a visit. */
static struct visit begin_visit(const struct state *state, const struct stroke *stroke)
{
    int32_t cells = (int32_t)state->cells;
    float side = 1 / (float)cells, near = near_of(state);
    struct visit visit = {.stroke = stroke, .near = near, .beside = near + 1e-3f * side, .cells = cells};
    for (int c = 0; c < 3; c++) {
        float extent = fabsf(stroke->half[c]) + state->reach;
        visit.low[c] = (int32_t)floorf((stroke->middle[c] - extent) * (float)cells);
        visit.high[c] = (int32_t)floorf((stroke->middle[c] + extent) * (float)cells);
        visit.high[c] = visit.high[c] < visit.low[c] + cells ? visit.high[c] : visit.low[c] + cells - 1;
        visit.wraps = visit.wraps || extent + side >= 0.5f;
    }
    return visit;
}

/* Visits the cells of a row that a stroke reaches: counts it in each, or, with a list, enters it.
 *   part  of the stroke that lies beside the row */
static void visit_row(struct state *state, const struct visit *visit, int32_t y, int32_t z, const float part[2],
                      uint32_t number, uint32_t *list)
{
    int32_t cells = visit->cells, range[2];
    float side = 1 / (float)cells;
    bound_cells(visit, 0, part, range);
    for (int32_t x = range[0]; x <= range[1]; x++) {
        const float middle[3] = {((float)x + 0.5f) * side, ((float)y + 0.5f) * side, ((float)z + 0.5f) * side};
        if (!visit->wraps && squared_distance(visit->stroke, middle) > visit->near * visit->near)
            continue;
        int32_t cell = ((z + cells) % cells * cells + (y + cells) % cells) * cells + (x + cells) % cells;
        if (list)
            list[--state->first[cell]] = number;
        else
            state->first[cell]++;
    }
}

/* Visits the cells that a stroke reaches: of each layer the rows beside the part of the stroke that lies beside it, and
 * of each row likewise. */
static void visit_cells(struct state *state, uint32_t number, uint32_t *list)
{
    const struct visit visit = begin_visit(state, &state->strokes[number]);
    for (int32_t z = visit.low[2]; z <= visit.high[2]; z++) {
        float layer[2] = {-1, 1};
        int32_t range[2];
        if (!cut_part(&visit, 2, z, layer))
            continue;
        bound_cells(&visit, 1, layer, range);
        for (int32_t y = range[0]; y <= range[1]; y++) {
            float row[2] = {layer[0], layer[1]};
            if (cut_part(&visit, 1, y, row))
                visit_row(state, &visit, y, z, row, number, list);
        }
    }
}

/* Visits the cells of all strokes, the last stroke first, so that a cell lists them in their order. */
static void visit_all(const struct solid_job *job, struct state *state, double from, uint32_t *list)
{
    for (uint32_t i = state->count; i-- > 0;) {
        visit_cells(state, i, list);
        if (i % REPORTED == 0)
            hatch_progress_report(job->progress, from + LISTED / 2 * (1 - (double)i / state->count));
    }
}

static enum hatch_status list_cells(const struct solid_job *job, struct state *state, struct hatch_err *err)
{
    uint32_t cell_count = state->cells * state->cells * state->cells;
    uint64_t entries = 0;
    HATCH_TRY(HATCH_ALLOC(job->arena, &state->first, (size_t)cell_count + 1, err));
    visit_all(job, state, SCATTERED, NULL);
    for (uint32_t cell = 0; cell < cell_count; cell++)
        entries += state->first[cell];
    if (entries > UINT32_MAX)
        return hatch_fail(err, HATCH_LIMIT, "%u strokes are too many: want fewer, or narrower ones", state->count);
    for (uint32_t cell = 1; cell <= cell_count; cell++)
        state->first[cell] += state->first[cell - 1];
    HATCH_TRY(HATCH_ALLOC(job->arena, &state->list, (size_t)entries, err));
    visit_all(job, state, SCATTERED + LISTED / 2, state->list);
    return HATCH_OK;
}

/* Finds the number of strokes, their reach, and the cells. */
static void lay_out(const struct hatch_solid_style *style, struct state *state)
{
    float radius = style->width / 2, volume = 3.1415927f * radius * radius * (style->length + 4 * radius / 3);
    state->style = style;
    state->count = (uint32_t)ceilf(style->density / volume);
    /* Strokes grow until e^-12 of the places are uncovered. */
    state->reach = radius * fmaxf(1.2f, sqrtf(12 / style->density));
    state->cells = (uint32_t)(1 / state->reach);
    state->cells = state->cells < CELLS_MAX ? state->cells : CELLS_MAX;
}

uint64_t solid_strokes_bytes(const struct hatch_solid_style *style)
{
    struct state state;
    lay_out(style, &state);
    double cell_count = pow(state.cells, 3), near = (double)near_of(&state);
    double volume = 3.141592653589793 * near * near * ((double)style->length + near * 4 / 3);
    double listed = sizeof *state.list * fmin(volume, 1) * cell_count; /* by one stroke */
    return (uint64_t)(state.count * (sizeof *state.strokes + HATCH_SOLID_POINT_BYTES + listed) +
                      sizeof *state.first * cell_count);
}

enum hatch_status solid_strokes_field(const struct solid_job *job, struct solid_field *field, struct hatch_err *err)
{
    struct state *state;
    HATCH_TRY(HATCH_ALLOC(job->arena, &state, 1, err));
    lay_out(job->style, state);
    HATCH_TRY(scatter(job, state, err));
    HATCH_TRY(list_cells(job, state, err));
    *field = (struct solid_field){value, state, SCATTERED + LISTED};
    return HATCH_OK;
}
