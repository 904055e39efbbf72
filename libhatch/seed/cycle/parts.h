/* The methods that make uniform cycles. A pattern of crumbs is a number in base 4, its first crumb the most
 * significant digit. The de Bruijn graph of order K has a vertex for each pattern of K crumbs and an edge for each of
 * K + 1, from its first K crumbs to its last K. Private to seed. */
#ifndef HATCH_SEED_CYCLE_PARTS_H
#define HATCH_SEED_CYCLE_PARTS_H

#include "base/random.h"
#include "seed/cycle/cycle.h"

/* A sequence of random numbers. */
struct hatch_cycle_rng {
    uint64_t seed, stream;
    uint64_t index; /* of the next number */
};

/* Returns a random number below limit; its bias is under 2^-40 of it for the limits used here. */
static inline uint32_t hatch_cycle_random(struct hatch_cycle_rng *rng, uint32_t limit)
{
    uint64_t bits = hatch_random_u64(rng->seed, rng->stream, rng->index++);
    return (uint32_t)((bits >> 32) * limit >> 32);
}

/* Chooses the edges of a connected graph of an order in which every vertex has as many edges in as out and patterns of
 * every length appear equally often, up to one.
 *   count  number of edges
 *   order  with 4^order <= count <= 4^(order + 1)
 *   edges  out: 4^(order + 1) entries, 0 or 1 */
enum hatch_status hatch_cycle_balance(uint32_t count, int order, struct hatch_cycle_rng *rng,
                                      struct hatch_arena *scratch, uint8_t *edges,
                                      struct hatch_err *err) HATCH_MUST_USE;

/* Makes a uniformly random Eulerian circuit of a connected, balanced graph.
 *   edges   as from hatch_cycle_balance
 *   crumbs  out: one per edge */
enum hatch_status hatch_cycle_circuit(const uint8_t *edges, int order, struct hatch_cycle_rng *rng,
                                      struct hatch_arena *scratch, uint8_t *crumbs,
                                      struct hatch_err *err) HATCH_MUST_USE;

/* Runs Algorithm 1 of the paper, iteratively; arguments as for hatch_cycle_make.
 * HATCH_LIMIT when steps_max does not suffice. */
enum hatch_status hatch_cycle_backtrack(uint32_t count, uint64_t steps_max, struct hatch_cycle_rng *rng,
                                        struct hatch_arena *scratch, uint8_t *crumbs, uint64_t *steps,
                                        struct hatch_err *err) HATCH_MUST_USE;

#endif
