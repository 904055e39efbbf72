/* What the makers of uniform cycles share. A pattern of crumbs is a number of base 4, its first crumb
 * the highest. The de Bruijn graph of order K has a vertex for each pattern of K crumbs and an edge
 * for each of K + 1, from its first K crumbs to its last K. */
#ifndef HATCH_SEED_CYCLE_PARTS_H
#define HATCH_SEED_CYCLE_PARTS_H

#include "base/random.h"
#include "seed/cycle.h"

/* A sequence of random numbers. */
struct cycle_dice {
    uint64_t seed, stream, index;
};

/* A number below limit; its bias is under 2^-40 of it for the limits used here. */
static inline uint32_t cycle_roll(struct cycle_dice *dice, uint32_t limit)
{
    uint64_t bits = hatch_random_u64(dice->seed, dice->stream, dice->index++);
    return (uint32_t)((bits >> 32) * limit >> 32);
}

/* The edges of a connected graph of the given order in which every vertex has as many edges in as
 * out, `count` in all, and whose patterns of every length are spread as evenly as can be.
 * edges: 4^(order + 1) entries, 0 or 1. order: with 4^order <= count <= 4^(order + 1). */
enum hatch_status hatch_cycle_balance(uint32_t count, int order, struct cycle_dice *dice, struct hatch_arena *scratch,
                                      uint8_t *edges, struct hatch_err *err) HATCH_MUST_USE;

/* The crumbs of an Eulerian circuit of a connected, balanced graph, each as likely as any other.
 * crumbs: one for each edge. */
enum hatch_status hatch_cycle_circuit(const uint8_t *edges, int order, struct cycle_dice *dice,
                                      struct hatch_arena *scratch, uint8_t *crumbs,
                                      struct hatch_err *err) HATCH_MUST_USE;

/* Algorithm 1 as printed, without its recursion. */
enum hatch_status hatch_cycle_backtrack(uint32_t count, uint64_t steps_max, struct cycle_dice *dice,
                                        struct hatch_arena *scratch, uint8_t *crumbs, uint64_t *steps,
                                        struct hatch_err *err) HATCH_MUST_USE;

#endif
