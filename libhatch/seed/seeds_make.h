/* Makes random seed sets and keeps those whose seed points are spread best. */
#ifndef HATCH_SEED_SEEDS_MAKE_H
#define HATCH_SEED_SEEDS_MAKE_H

#include "seed/seeds.h"

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

#endif
