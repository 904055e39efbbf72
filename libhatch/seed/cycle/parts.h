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

/* Returns a random number below limit. Probabilities are equal for a power of two; for 3, the only other limit used
 * here, they are off by less than 2^-32. */
static inline uint32_t hatch_cycle_random(struct hatch_cycle_rng *rng, uint32_t limit)
{
    uint64_t bits = hatch_random_u64(rng->seed, rng->stream, rng->index++);
    return (uint32_t)((bits >> 32) * limit >> 32);
}

/* Chooses edges of the de Bruijn graph that form a connected graph. Every vertex has as many of them in as out, and the
 * counts of any two patterns of the same length differ by at most one.
 *   count  number of edges to choose
 *   order  with 4^order <= count <= 4^(order + 1)
 *   edges  out: per edge of the de Bruijn graph, 1 if it is chosen, else 0; 4^(order + 1) entries */
enum hatch_status hatch_cycle_balance(uint32_t count, int order, struct hatch_cycle_rng *rng,
                                      struct hatch_arena *scratch, uint8_t *edges,
                                      struct hatch_err *err) HATCH_MUST_USE;

/* Makes a uniformly random Eulerian circuit of a connected graph whose vertices have as many edges in as out.
 *   edges   as from hatch_cycle_balance
 *   crumbs  out: one per edge */
enum hatch_status hatch_cycle_circuit(const uint8_t *edges, int order, struct hatch_cycle_rng *rng,
                                      struct hatch_arena *scratch, uint8_t *crumbs,
                                      struct hatch_err *err) HATCH_MUST_USE;

/* Runs Algorithm 1 of the paper, without recursion; arguments as for hatch_cycle_make.
 * HATCH_LIMIT when steps_max or memory does not suffice. */
enum hatch_status hatch_cycle_backtrack(uint32_t count, uint64_t steps_max, struct hatch_cycle_rng *rng,
                                        struct hatch_arena *scratch, uint8_t *crumbs, uint64_t *steps,
                                        struct hatch_err *err) HATCH_MUST_USE;

#endif
