/* Random Eulerian circuits. By the BEST theorem (van Aardenne-Ehrenfest & de Bruijn 1951) a circuit corresponds to a
 * spanning tree of last exits towards a root and an order of the other exits at each vertex. A uniformly random tree
 * (Wilson, "Generating random spanning trees more quickly than the cover time", STOC 1996) and random orders yield a
 * uniformly random circuit. */
#include "seed/cycle/parts.h"

/* Chooses a random exit of a vertex, the crumb of an outgoing edge.
 *   exits  bit mask of the exits left
 *   keep   exit to choose only if there is no other; 4: none */
static uint32_t random_exit(uint8_t exits, uint32_t keep, struct hatch_cycle_rng *rng)
{
    uint32_t choice[4], count = 0;
    for (uint32_t b = 0; b < 4; b++)
        if (exits >> b & 1 && b != keep)
            choice[count++] = b;
    return count == 0 ? keep : count == 1 ? choice[0] : choice[hatch_cycle_random(rng, count)];
}

/* Makes a uniformly random spanning tree.
 *   in_tree  scratch, per vertex; zeros
 *   last     out: per vertex, the exit by which the circuit leaves it last; 4 for the root */
static void make_tree(const uint8_t *exits, uint32_t vertices, uint32_t root, struct hatch_cycle_rng *rng,
                      uint8_t *in_tree, uint8_t *last)
{
    in_tree[root] = 1;
    last[root] = 4;
    for (uint32_t start = 0; start < vertices; start++) {
        for (uint32_t v = start; !in_tree[v]; v = (4 * v + last[v]) % vertices)
            last[v] = (uint8_t)random_exit(exits[v], 4, rng);
        for (uint32_t v = start; !in_tree[v]; v = (4 * v + last[v]) % vertices)
            in_tree[v] = 1;
    }
}

enum hatch_status hatch_cycle_circuit(const uint8_t *edges, int order, struct hatch_cycle_rng *rng,
                                      struct hatch_arena *scratch, uint8_t *crumbs, struct hatch_err *err)
{
    uint32_t vertices = (uint32_t)1 << 2 * order;
    struct hatch_arena_mark mark = hatch_arena_mark(scratch);
    uint8_t *exits = HATCH_NEW(scratch, uint8_t, vertices, err);
    uint8_t *in_tree = exits ? HATCH_NEW(scratch, uint8_t, vertices, err) : NULL;
    uint8_t *last = in_tree ? HATCH_NEW(scratch, uint8_t, vertices, err) : NULL;
    if (!last) {
        hatch_arena_rewind(scratch, mark);
        return HATCH_LIMIT;
    }
    size_t count = 0;
    for (size_t edge = 0; edge < (size_t)4 * vertices; edge++)
        if (edges[edge]) {
            exits[edge / 4] |= (uint8_t)(1 << edge % 4);
            count++;
        }
    uint32_t v = hatch_cycle_random(rng, vertices);
    make_tree(exits, vertices, v, rng, in_tree, last);
    for (size_t i = 0; i < count; i++) {
        uint32_t crumb = random_exit(exits[v], last[v], rng);
        exits[v] &= (uint8_t) ~(1 << crumb);
        crumbs[i] = (uint8_t)crumb;
        v = (4 * v + crumb) % vertices;
    }
    hatch_arena_rewind(scratch, mark);
    return HATCH_OK;
}
