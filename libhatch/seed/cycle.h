/* Uniform cycles: cyclic sequences of crumbs (0 .. 3) in which every pattern of m crumbs appears
 * floor(N/4^m) or ceil(N/4^m) times, for every m (Recursive Procedural Tonal Art Maps, §4.1). Turned
 * by one crumb at a time, one cycle gives the N positions of a seed set (seed/seeds.h). */
#ifndef HATCH_SEED_CYCLE_H
#define HATCH_SEED_CYCLE_H

#include <stdbool.h>

#include "base/arena.h"

#define HATCH_CYCLE_MIN 2u
#define HATCH_CYCLE_MAX 16777216u

enum hatch_cycle_method {
    HATCH_CYCLE_ANY,      /* any N, in linear time; euler where that can be */
    HATCH_CYCLE_EULER,    /* N = 4^K: an Eulerian circuit of the de Bruijn graph, each as likely */
    HATCH_CYCLE_BACKTRACK /* N = 4^K: the paper's Algorithm 1: ends at once or never, the latter the
                             oftener the more seeds */
};

struct hatch_cycle_options {
    enum hatch_cycle_method method;
    uint32_t count; /* N, HATCH_CYCLE_MIN .. HATCH_CYCLE_MAX */
    uint64_t seed;
    uint64_t stream;    /* cycles of one seed and several streams have nothing to do with each other */
    uint64_t steps_max; /* backtrack: crumbs that may be tried; others ignore it */
};

/* Makes a cycle; crumbs: count entries. *steps (may be NULL) receives how many crumbs backtracking
 * tried, 0 for the others. HATCH_USAGE where the method cannot make that N; HATCH_LIMIT when
 * steps_max or the memory does not suffice. */
enum hatch_status hatch_cycle_make(const struct hatch_cycle_options *options, struct hatch_arena *scratch,
                                   uint8_t *crumbs, uint64_t *steps, struct hatch_err *err) HATCH_MUST_USE;

/* K where count is 4^K, else -1. */
int hatch_cycle_order(uint32_t count);

#endif
