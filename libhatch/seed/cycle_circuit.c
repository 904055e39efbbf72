/* A random Eulerian circuit. By the BEST theorem (van Aardenne-Ehrenfest & de Bruijn 1951) circuits
 * correspond to a spanning tree of last exits towards a root and an order of the other exits at each
 * vertex: a uniformly random tree (Wilson, "Generating random spanning trees more quickly than the
 * cover time", STOC 1996) and random orders give a uniformly random circuit. */
#include "seed/cycle_parts.h"

#include <string.h>

/* One of the marked edges out of a vertex, by lot; keep: one that does not count, or 4. */
static uint32_t roll_edge(uint8_t marked, uint32_t keep, struct cycle_dice *dice)
{
    uint32_t choice[4], count = 0;
    for (uint32_t b = 0; b < 4; b++)
        if (marked >> b & 1 && b != keep)
            choice[count++] = b;
    return count == 0 ? keep : count == 1 ? choice[0] : choice[cycle_roll(dice, count)];
}

/* last[v]: the edge by which the circuit leaves v for the last time; 4 for the root. */
static void span_tree(const uint8_t *exits, uint32_t vertices, uint32_t root, struct cycle_dice *dice, uint8_t *in_tree,
                      uint8_t *last)
{
    in_tree[root] = 1;
    last[root] = 4;
    for (uint32_t start = 0; start < vertices; start++) {
        for (uint32_t v = start; !in_tree[v]; v = (4 * v + last[v]) % vertices)
            last[v] = (uint8_t)roll_edge(exits[v], 4, dice);
        for (uint32_t v = start; !in_tree[v]; v = (4 * v + last[v]) % vertices)
            in_tree[v] = 1;
    }
}

enum hatch_status hatch_cycle_circuit(const uint8_t *edges, int order, struct cycle_dice *dice,
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
    uint32_t v = cycle_roll(dice, vertices);
    span_tree(exits, vertices, v, dice, in_tree, last);
    for (size_t i = 0; i < count; i++) {
        uint32_t crumb = roll_edge(exits[v], last[v], dice);
        exits[v] &= (uint8_t) ~(1 << crumb);
        crumbs[i] = (uint8_t)crumb;
        v = (4 * v + crumb) % vertices;
    }
    hatch_arena_rewind(scratch, mark);
    return HATCH_OK;
}
