/* Makes random seed sets and keeps those whose seed points are spread most evenly. */
#ifndef HATCH_SEED_SEEDS_MAKE_H
#define HATCH_SEED_SEEDS_MAKE_H

#include "base/progress.h"
#include "seed/seeds.h"

struct hatch_seeds_options {
    struct hatch_cycle_options cycle;      /* its stream is ignored; steps_max is that of each layer */
    uint32_t layers;                       /* 1 .. HATCH_SEED_LAYERS_MAX */
    uint32_t candidates;                   /* random sets tried per layer; 0: 100000 / cycle.count, within 1 .. 1000 */
    const struct hatch_progress *progress; /* NULL: nobody is told */
};

/* Makes a random seed set for each layer, the best of several candidates. The best one has the largest a² b, where a
 * is the smallest distance within the set and b the smallest distance among the points of the set and of all layers
 * before it, each divided by its bound (hatch_spread_bound). The factor b keeps layers from putting strokes on top of
 * each other; the first layer is chosen by a alone.
 *   seeds  out, in arena
 *   steps  out: number of crumbs that HATCH_CYCLE_BACKTRACK tried; candidates that it does not find are left out
 * Statuses of hatch_cycle_make. */
enum hatch_status hatch_seeds_make(const struct hatch_seeds_options *options, struct hatch_arena *arena,
                                   struct hatch_arena *scratch, struct hatch_seeds *seeds, uint64_t *steps,
                                   struct hatch_err *err) HATCH_MUST_USE;

#endif
