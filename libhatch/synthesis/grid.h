/* Grids of values in two or three dimensions, and their Laplacian pyramids: Burt & Adelson, "The Laplacian Pyramid as a
 * Compact Image Code", IEEE Transactions on Communications, 1983. */
#ifndef HATCH_SYNTHESIS_GRID_H
#define HATCH_SYNTHESIS_GRID_H

#include <stdbool.h>
#include <stddef.h>

#include "base/arena.h"
#include "base/parallel.h"

struct hatch_grid {
    uint32_t size[3]; /* along x, y and z; an image has size[2] 1 */
    bool periodic;    /* beyond its borders it repeats; otherwise it is reflected there */
    float *values;    /* [(z * size[1] + y) * size[0] + x] */
};

static inline size_t hatch_grid_count(const struct hatch_grid *grid)
{
    return (size_t)grid->size[0] * grid->size[1] * grid->size[2];
}

/* Makes a grid of unset values with half as many along each axis, rounded up. */
enum hatch_status hatch_grid_make_half(const struct hatch_grid *fine, struct hatch_arena *arena,
                                       struct hatch_grid *coarse, struct hatch_err *err) HATCH_MUST_USE;

/* Sets coarse to the smoothed fine one at every second value. */
void hatch_grid_reduce(const struct hatch_grid *fine, const struct hatch_grid *coarse, struct hatch_pool *pool);

/* Adds the coarse grid, interpolated, times a factor to the fine one. A factor of -1 after hatch_grid_reduce makes a
 * band of the pyramid, a factor of 1 takes it back. */
void hatch_grid_add(const struct hatch_grid *fine, const struct hatch_grid *coarse, float factor,
                    struct hatch_pool *pool);

/* Sorts the values. */
void hatch_grid_sort(const struct hatch_grid *grid);

#define HATCH_GRID_RANKS 4097u

/* Maps the values so that they are distributed as others are.
 *   sorted  [count], ascending
 *   ranks   [HATCH_GRID_RANKS], overwritten */
void hatch_grid_match(const struct hatch_grid *grid, const float *sorted, size_t count, struct hatch_pool *pool,
                      double *ranks);

#endif
