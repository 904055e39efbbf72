/* Chooses the patterns of a uniform cycle of any length.
 *
 * The counts of patterns of m + 1 crumbs follow from those of m: for every pattern u of m - 1 crumbs the counts of
 * a·u·b form a 4x4 matrix whose rows sum to the counts of a·u and whose columns sum to those of u·b. All counts of
 * one length are f or f + 1. Subtracting f leaves a 0-1 matrix whose row sums differ by at most one, as do its column
 * sums. Such a matrix always exists (Gale; Ryser 1957), and a greedy choice finds it. K such steps take time linear
 * in the count.
 *
 * The last matrices hold the edges of a graph with equal in- and out-degrees. If it is not connected, two edges of
 * one matrix that lie in different components exchange their heads, which keeps all sums. Every vertex is in two
 * matrices, as a head and as a tail, so the matrices are connected as the de Bruijn graph is; once all matrices are
 * done, there is one component. */
#include "seed/cycle/parts.h"

#include <string.h>

/* Puts the ones of a row into the columns with the largest remaining sums; ties are broken at random.
 *   ones       their number
 *   remaining  in and out: per column, its sum over the rows that are left */
static void fill_row(uint8_t ones, uint8_t remaining[4], struct hatch_cycle_rng *rng, uint8_t row[4])
{
    uint32_t key[4];
    for (int b = 0; b < 4; b++)
        key[b] = (uint32_t)remaining[b] << 24 | hatch_cycle_random(rng, 1u << 24);
    memset(row, 0, 4);
    while (ones--) {
        int best = -1;
        for (int b = 0; b < 4; b++)
            if (!row[b] && (best < 0 || key[b] > key[best]))
                best = b;
        row[best] = 1;
        remaining[best]--;
    }
}

/* Computes the counts of patterns of length + 1 crumbs from those of length crumbs.
 *   length  1 upwards
 *   base    f, the smaller of the new counts */
static void refine(const uint8_t *counts, int length, uint8_t base, struct hatch_cycle_rng *rng, uint8_t *finer)
{
    size_t middle_count = (size_t)1 << 2 * (length - 1);
    for (size_t u = 0; u < middle_count; u++) {
        uint8_t remaining[4];
        for (size_t b = 0; b < 4; b++)
            remaining[b] = (uint8_t)(counts[4 * u + b] - 4 * base);
        size_t first = hatch_cycle_random(rng, 4);
        for (size_t i = 0; i < 4; i++) {
            size_t tail = (first + i) % 4 * middle_count + u;
            uint8_t row[4];
            fill_row((uint8_t)(counts[tail] - 4 * base), remaining, rng, row);
            for (size_t b = 0; b < 4; b++)
                finer[4 * tail + b] = (uint8_t)(base + row[b]);
        }
    }
}

/* Returns the root of a vertex's component, by union-find with path halving. */
static uint32_t find_component(uint32_t *parent, uint32_t vertex)
{
    while (parent[vertex] != vertex)
        vertex = parent[vertex] = parent[parent[vertex]];
    return vertex;
}

/* Exchanges heads in the matrix of pattern u until its edges are in one component. */
static void join_matrix(uint8_t *edges, uint32_t u, uint32_t middle_count, uint32_t *parent)
{
    uint32_t first = UINT32_MAX;
    for (uint32_t edge = 0; edge < 16; edge++) {
        uint32_t tail = edge / 4 * middle_count + u, head = edge % 4;
        if (!edges[4 * tail + head])
            continue;
        if (first == UINT32_MAX) {
            first = edge;
            continue;
        }
        uint32_t first_tail = first / 4 * middle_count + u, first_head = first % 4;
        uint32_t a = find_component(parent, first_tail), b = find_component(parent, tail);
        if (a == b)
            continue;
        /* No edge joins two components, so the new edges did not exist. */
        edges[4 * first_tail + first_head] = edges[4 * tail + head] = 0;
        edges[4 * first_tail + head] = edges[4 * tail + first_head] = 1;
        parent[b] = a;
        first = first / 4 * 4 + head;
    }
}

static void join_components(uint8_t *edges, int order, uint32_t *parent)
{
    uint32_t vertices = (uint32_t)1 << 2 * order, middle_count = vertices / 4;
    for (uint32_t v = 0; v < vertices; v++)
        parent[v] = v;
    for (uint32_t edge = 0; edge < 4 * vertices; edge++)
        if (edges[edge])
            parent[find_component(parent, edge % vertices)] = find_component(parent, edge / 4);
    for (uint32_t u = 0; u < middle_count; u++)
        join_matrix(edges, u, middle_count, parent);
}

enum hatch_status hatch_cycle_balance(uint32_t count, int order, struct hatch_cycle_rng *rng,
                                      struct hatch_arena *scratch, uint8_t *edges, struct hatch_err *err)
{
    size_t vertices = (size_t)1 << 2 * order;
    struct hatch_arena_mark mark = hatch_arena_mark(scratch);
    uint8_t *counts = HATCH_NEW(scratch, uint8_t, vertices < 4 ? 4 : vertices, err);
    uint32_t *parent = counts ? HATCH_NEW(scratch, uint32_t, vertices, err) : NULL;
    if (!parent) {
        hatch_arena_rewind(scratch, mark);
        return HATCH_LIMIT;
    }
    /* Only differences between counts matter, and these are at most 7, so counts are kept modulo 256. */
    uint8_t remaining[4] = {1, 1, 1, 1}, extra[4];
    fill_row((uint8_t)(count % 4), remaining, rng, extra);
    for (int b = 0; b < 4; b++)
        edges[b] = (uint8_t)(count / 4 + extra[b]);
    for (int length = 1; length <= order; length++) {
        memcpy(counts, edges, (size_t)1 << 2 * length);
        refine(counts, length, (uint8_t)(count >> 2 * (length + 1)), rng, edges);
    }
    if (order > 0)
        join_components(edges, order, parent);
    hatch_arena_rewind(scratch, mark);
    return HATCH_OK;
}
