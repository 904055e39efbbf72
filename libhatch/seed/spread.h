/* How well seeds are spread over their tile, and choosing the sets that are spread best. */
#ifndef HATCH_SEED_SPREAD_H
#define HATCH_SEED_SPREAD_H

#include "seed/seeds.h"

/* The largest smallest distance that count points of a unit torus can have: that of the hexagonal
 * grid, sqrt(2 / (sqrt(3) count)). */
double hatch_spread_bound(uint32_t count);

/* The smallest distance between two of the places, around the tile's edges too; 1 for one place.
 * Time is about linear in count. */
enum hatch_status hatch_spread_distance(const struct hatch_seed_place *places, uint32_t count,
                                        struct hatch_arena *scratch, double *distance,
                                        struct hatch_err *err) HATCH_MUST_USE;

/* The star discrepancy: the largest difference, over all boxes with a corner at 0, between the box's
 * area and its share of the places. Time is quadratic in count. */
enum hatch_status hatch_spread_discrepancy(const struct hatch_seed_place *places, uint32_t count,
                                           struct hatch_arena *scratch, double *discrepancy,
                                           struct hatch_err *err) HATCH_MUST_USE;

struct hatch_seeds_options {
    struct hatch_cycle_options cycle; /* stream is set for each set */
    uint32_t layers;                  /* 1 .. HATCH_SEED_LAYERS_MAX */
    uint32_t candidates;              /* sets drawn for each layer; 0: by size, a thousand of up to a
                                         hundred seeds, one from a hundred thousand on */
};

/* Draws candidates for each layer in turn and keeps the one of the largest product of two figures: the
 * square of the smallest distance within it over its bound, and the smallest distance among it and the
 * layers before it over theirs, so that layers do not put strokes on each other. *steps receives how many crumbs
 * backtracking tried. */
enum hatch_status hatch_seeds_make(const struct hatch_seeds_options *options, struct hatch_arena *arena,
                                   struct hatch_arena *scratch, struct hatch_seeds *seeds, uint64_t *steps,
                                   struct hatch_err *err) HATCH_MUST_USE;

/* The smallest of all layers' smallest distances, over the bound of each; and the smallest distance
 * between any two seeds of all layers, over their bound. */
enum hatch_status hatch_seeds_spread(const struct hatch_seeds *seeds, struct hatch_arena *scratch, double *within,
                                     double *together, struct hatch_err *err) HATCH_MUST_USE;

#endif
