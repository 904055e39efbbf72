/* Measures how evenly seed points are spread over their tile. */
#ifndef HATCH_SEED_SPREAD_H
#define HATCH_SEED_SPREAD_H

#include "seed/seeds.h"

/* Returns the upper bound of the smallest distance between count points on a unit torus: the spacing of a hexagonal
 * grid of the same density, sqrt(2 / (sqrt(3) count)). */
double hatch_spread_bound(uint32_t count);

/* Seed points sorted into the cells of a grid of 2^bits by 2^bits. A cell is at least as wide as
 * hatch_spread_bound(count), so that of these points two at the smallest distance lie in the same cell or in adjacent
 * ones. */
struct hatch_spread_cells {
    int bits;
    uint32_t *first;                 /* per cell, its first entry in points; 4^bits + 1 entries */
    struct hatch_seed_point *points; /* count entries, ordered by cell */
};

/* Sorts points into cells.
 *   count  at least 1
 *   cells  out, in arena */
enum hatch_status hatch_spread_sort(const struct hatch_seed_point *points, uint32_t count, struct hatch_arena *arena,
                                    struct hatch_spread_cells *cells, struct hatch_err *err) HATCH_MUST_USE;

/* Returns the smaller of `distance` and the distance from a point to the nearest of sorted points. Distances above
 * hatch_spread_bound(count) may be missed, in which case the result is too large. */
double hatch_spread_nearest(const struct hatch_spread_cells *cells, const struct hatch_seed_point *point,
                            double distance);

/* Computes the smallest distance between any two seed points on the torus; 1 for a single point. Time is about linear
 * in count. */
enum hatch_status hatch_spread_distance(const struct hatch_seed_point *points, uint32_t count,
                                        struct hatch_arena *scratch, double *distance,
                                        struct hatch_err *err) HATCH_MUST_USE;

/* Computes the star discrepancy: the largest difference, over all boxes with a corner at 0, between the area of the box
 * and the share of the seed points that it contains. Time is quadratic in count. */
enum hatch_status hatch_spread_discrepancy(const struct hatch_seed_point *points, uint32_t count,
                                           struct hatch_arena *scratch, double *discrepancy,
                                           struct hatch_err *err) HATCH_MUST_USE;

/* Computes how evenly the seed points of seed sets are spread.
 *   within    out: smallest distance within a layer over its bound, the least of all layers
 *   together  out: smallest distance between any two seed points of all layers, over their bound */
enum hatch_status hatch_seeds_spread(const struct hatch_seeds *seeds, struct hatch_arena *scratch, double *within,
                                     double *together, struct hatch_err *err) HATCH_MUST_USE;

#endif
