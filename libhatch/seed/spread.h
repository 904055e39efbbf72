/* Measures how evenly seed points are spread over their tile, and makes seed sets that are spread well. */
#ifndef HATCH_SEED_SPREAD_H
#define HATCH_SEED_SPREAD_H

#include "seed/seeds.h"

/* Returns the largest possible smallest distance between count points of a unit torus: that of the hexagonal grid,
 * sqrt(2 / (sqrt(3) count)). */
double hatch_spread_bound(uint32_t count);

/* Computes the smallest distance between two seed points, on the torus; 1 for a single one. Time is about linear in
 * count. */
enum hatch_status hatch_spread_distance(const struct hatch_seed_point *points, uint32_t count,
                                        struct hatch_arena *scratch, double *distance,
                                        struct hatch_err *err) HATCH_MUST_USE;

/* Computes the star discrepancy: the largest difference, over all boxes with a corner at 0, between the area of the
 * box and its share of the seed points. Time is quadratic in count. */
enum hatch_status hatch_spread_discrepancy(const struct hatch_seed_point *points, uint32_t count,
                                           struct hatch_arena *scratch, double *discrepancy,
                                           struct hatch_err *err) HATCH_MUST_USE;

struct hatch_seeds_options {
    struct hatch_cycle_options cycle; /* its stream is ignored */
    uint32_t layers;                  /* 1 .. HATCH_SEED_LAYERS_MAX */
    uint32_t candidates;              /* random sets per layer; 0: by cycle.count, from 1000 for up to a hundred seed
                                         points to 1 from a hundred thousand on */
};

/* Makes a random seed set per layer, the best of several candidates: the one with the largest product of two figures,
 * the square of the smallest distance within the set over its bound, and the smallest distance among the set and all
 * layers before it over their bound, so that layers do not put strokes on top of each other.
 *   seeds  out, in arena
 *   steps  out: number of crumbs that HATCH_CYCLE_BACKTRACK tried
 * Statuses of hatch_cycle_make. */
enum hatch_status hatch_seeds_make(const struct hatch_seeds_options *options, struct hatch_arena *arena,
                                   struct hatch_arena *scratch, struct hatch_seeds *seeds, uint64_t *steps,
                                   struct hatch_err *err) HATCH_MUST_USE;

/* Computes the spread of seed sets.
 *   within    out: smallest distance within a layer over its bound, the least of all layers
 *   together  out: smallest distance between any two seed points of all layers, over their bound */
enum hatch_status hatch_seeds_spread(const struct hatch_seeds *seeds, struct hatch_arena *scratch, double *within,
                                     double *together, struct hatch_err *err) HATCH_MUST_USE;

#endif
