#include "synthesis/grid.h"

#include <stdlib.h>
#include <string.h>

#define BINS (HATCH_GRID_RANKS - 1)

struct job {
    const struct hatch_grid *fine, *coarse;
    float factor;
};

/* Returns the coordinate of the value at a coordinate that may lie beyond a border by a few. */
static uint32_t inside(const struct hatch_grid *grid, uint32_t axis, int64_t at)
{
    const int64_t size = grid->size[axis];
    if (grid->periodic)
        return (uint32_t)((at + 8 * size) % size);
    while (at < 0 || at >= size)
        at = size == 1 ? 0 : at < 0 ? -at : 2 * size - 2 - at;
    return (uint32_t)at;
}

enum hatch_status hatch_grid_make_half(const struct hatch_grid *fine, struct hatch_arena *arena,
                                       struct hatch_grid *coarse, struct hatch_err *err)
{
    struct hatch_grid made = *fine;
    for (uint32_t axis = 0; axis < 3; axis++)
        made.size[axis] = (fine->size[axis] + 1) / 2;
    HATCH_TRY(HATCH_ALLOC_UNSET(arena, &made.values, hatch_grid_count(&made), err));
    *coarse = made;
    return HATCH_OK;
}

/* Sets one row of the coarse grid. */
static void reduce_row(void *context, uint32_t row)
{
    static const float weights[5] = {0.0625f, 0.25f, 0.375f, 0.25f, 0.0625f};
    const struct job *job = context;
    const struct hatch_grid *fine = job->fine, *coarse = job->coarse;
    const int64_t y = 2 * (int64_t)(row % coarse->size[1]), z = 2 * (int64_t)(row / coarse->size[1]);
    const int flat = fine->size[2] == 1;
    float *out = coarse->values + (size_t)row * coarse->size[0];
    for (uint32_t x = 0; x < coarse->size[0]; x++)
        out[x] = 0;
    for (int k = flat ? 2 : 0; k < (flat ? 3 : 5); k++)
        for (int j = 0; j < 5; j++) {
            const size_t from = (size_t)inside(fine, 2, z + k - 2) * fine->size[1] + inside(fine, 1, y + j - 2);
            const float *values = fine->values + from * fine->size[0];
            const float weight = (flat ? 1 : weights[k]) * weights[j];
            for (uint32_t x = 0; x < coarse->size[0]; x++) {
                float sum = 0;
                for (int i = 0; i < 5; i++)
                    sum += weights[i] * values[inside(fine, 0, 2 * (int64_t)x + i - 2)];
                out[x] += weight * sum;
            }
        }
}

void hatch_grid_reduce(const struct hatch_grid *fine, const struct hatch_grid *coarse, struct hatch_pool *pool)
{
    struct job job = {fine, coarse, 0};
    hatch_parallel_for(pool, coarse->size[1] * coarse->size[2], reduce_row, &job);
}

/* The values of the coarse grid that lie about one of the fine grid along an axis. */
struct taps {
    uint32_t count, at[3];
    float weights[3];
};

static struct taps taps_of(const struct hatch_grid *coarse, uint32_t axis, uint32_t fine)
{
    const int64_t at = fine / 2;
    if (fine % 2)
        return (struct taps){2, {inside(coarse, axis, at), inside(coarse, axis, at + 1), 0}, {0.5f, 0.5f, 0}};
    return (struct taps){3,
                         {inside(coarse, axis, at - 1), inside(coarse, axis, at), inside(coarse, axis, at + 1)},
                         {0.125f, 0.75f, 0.125f}};
}

/* Adds to one row of the fine grid. */
static void add_row(void *context, uint32_t row)
{
    const struct job *job = context;
    const struct hatch_grid *fine = job->fine, *coarse = job->coarse;
    const struct taps y = taps_of(coarse, 1, row % fine->size[1]), z = taps_of(coarse, 2, row / fine->size[1]);
    float *out = fine->values + (size_t)row * fine->size[0];
    for (uint32_t k = 0; k < z.count; k++)
        for (uint32_t j = 0; j < y.count; j++) {
            const float *values = coarse->values + ((size_t)z.at[k] * coarse->size[1] + y.at[j]) * coarse->size[0];
            const float weight = job->factor * z.weights[k] * y.weights[j];
            for (uint32_t i = 0; i < fine->size[0]; i++) {
                const struct taps x = taps_of(coarse, 0, i);
                float sum = 0;
                for (uint32_t n = 0; n < x.count; n++)
                    sum += x.weights[n] * values[x.at[n]];
                out[i] += weight * sum;
            }
        }
}

void hatch_grid_add(const struct hatch_grid *fine, const struct hatch_grid *coarse, float factor,
                    struct hatch_pool *pool)
{
    struct job job = {fine, coarse, factor};
    hatch_parallel_for(pool, fine->size[1] * fine->size[2], add_row, &job);
}

static int by_value(const void *a, const void *b)
{
    const float x = *(const float *)a, y = *(const float *)b;
    return (x > y) - (x < y);
}

void hatch_grid_sort(const struct hatch_grid *grid)
{
    qsort(grid->values, hatch_grid_count(grid), sizeof *grid->values, by_value);
}

struct match {
    const struct hatch_grid *grid;
    float low, scale;    /* bin of a value: (value - low) * scale */
    const double *ranks; /* [BINS + 1]: where in the sorted values the borders of the bins lie, 0 .. count - 1 */
    const float *sorted;
    size_t count;
};

static void match_plane(void *context, uint32_t z)
{
    const struct match *match = context;
    const size_t plane = (size_t)match->grid->size[0] * match->grid->size[1];
    float *values = match->grid->values + z * plane;
    for (size_t i = 0; i < plane; i++) {
        const float place = (values[i] - match->low) * match->scale;
        const uint32_t bin = place < BINS - 1 ? (uint32_t)place : BINS - 1;
        const double *ranks = match->ranks + bin, part = (double)place - bin;
        const double rank = ranks[0] + (ranks[1] - ranks[0]) * (part < 1 ? part : 1);
        const size_t below = (size_t)rank < match->count - 1 ? (size_t)rank : match->count - 1;
        const float *at = match->sorted + below, next = below + 1 < match->count ? at[1] : at[0];
        values[i] = at[0] + (next - at[0]) * (float)(rank - (double)below);
    }
}

void hatch_grid_match(const struct hatch_grid *grid, const float *sorted, size_t count, struct hatch_pool *pool,
                      double *ranks)
{
    const size_t values = hatch_grid_count(grid);
    memset(ranks, 0, HATCH_GRID_RANKS * sizeof *ranks);
    float low = grid->values[0], high = low;
    for (size_t i = 1; i < values; i++) {
        low = grid->values[i] < low ? grid->values[i] : low;
        high = grid->values[i] > high ? grid->values[i] : high;
    }
    const float scale = high > low ? BINS / (high - low) : 0;
    for (size_t i = 0; i < values; i++) {
        const float place = (grid->values[i] - low) * scale;
        ranks[place < BINS - 1 ? (uint32_t)place + 1 : BINS]++;
    }
    for (uint32_t bin = 0; bin < BINS; bin++)
        ranks[bin + 1] += ranks[bin];
    for (uint32_t bin = 0; bin <= BINS; bin++)
        ranks[bin] *= (double)(count - 1) / (double)values;
    struct match match = {grid, low, scale, ranks, sorted, count};
    hatch_parallel_for(pool, grid->size[2], match_plane, &match);
}
