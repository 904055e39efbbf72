/* Uniform cycles: cyclic sequences of crumbs (base-4 digits, 0 .. 3) in which every pattern of m crumbs appears
 * floor(N/4^m) or ceil(N/4^m) times, for every m (Recursive Procedural Tonal Art Maps, §4.1). The N rotations of a
 * cycle are the positions of a seed set (seed/seeds.h). */
#ifndef HATCH_SEED_CYCLE_CYCLE_H
#define HATCH_SEED_CYCLE_CYCLE_H

#include <stdbool.h>

#include "base/arena.h"

#define HATCH_CYCLE_MIN 2u
#define HATCH_CYCLE_MAX 16777216u

enum hatch_cycle_method {
    HATCH_CYCLE_ANY,      /* any N, in linear time; the same as EULER for powers of four */
    HATCH_CYCLE_EULER,    /* N = 4^K: a uniformly random Eulerian circuit of the de Bruijn graph */
    HATCH_CYCLE_BACKTRACK /* N = 4^K: Algorithm 1 of the paper. It ends either quickly or practically never, and the
                             larger N, the more often never */
};

struct hatch_cycle_options {
    enum hatch_cycle_method method;
    uint32_t count;     /* N, HATCH_CYCLE_MIN .. HATCH_CYCLE_MAX */
    uint64_t seed;      /* random seed */
    uint64_t stream;    /* cycles with the same random seed and different streams are independent */
    uint64_t steps_max; /* BACKTRACK: number of crumbs to try; ignored by the others */
};

/* Makes a cycle.
 *   crumbs  out: count entries
 *   steps   out, on failure, too: number of crumbs that BACKTRACK tried, 0 for the other methods; may be NULL
 * HATCH_USAGE if the method cannot make a cycle of that length; HATCH_LIMIT when steps_max or memory does not
 * suffice. */
enum hatch_status hatch_cycle_make(const struct hatch_cycle_options *options, struct hatch_arena *scratch,
                                   uint8_t *crumbs, uint64_t *steps, struct hatch_err *err) HATCH_MUST_USE;

/* Returns K if count is 4^K, else -1. */
int hatch_cycle_order(uint32_t count);

#endif
