/* Which patterns a uniform cycle of any length holds.
 *
 * How often each pattern of m + 1 crumbs appears follows from how often those of m do: for every pattern
 * u of m - 1 crumbs the counts of a·u·b form a 4 by 4 matrix whose rows sum to the counts of a·u and
 * whose columns to those of u·b. All counts of one length are f or f + 1; so, less f in each entry, it
 * is a matrix of zeros and ones whose row sums differ by at most one, and so do its column sums: one
 * exists always (Gale; Ryser 1957), and a greedy choice finds it. From one length to the next, K times,
 * this takes time linear in the count. The last matrices hold the edges of a graph where in and out agree;
 * where it falls apart, two edges of a matrix that lie in different parts change their heads, which
 * keeps every sum. Every vertex lies in two matrices, one of its heads and one of its tails, and the
 * matrices hang together as the whole de Bruijn graph does: after all have been looked at, there is one
 * part. */
#include "seed/cycle_parts.h"

#include <string.h>

/* The columns where a row's ones go: those that still want most, by lot among equals. */
static void fill_row(uint8_t ones, uint8_t want[4], struct cycle_dice *dice, uint8_t row[4])
{
    uint32_t lot[4];
    for (int b = 0; b < 4; b++)
        lot[b] = (uint32_t)want[b] << 24 | cycle_roll(dice, 1u << 24);
    memset(row, 0, 4);
    while (ones--) {
        int best = -1;
        for (int b = 0; b < 4; b++)
            if (!row[b] && (best < 0 || lot[b] > lot[best]))
                best = b;
        row[best] = 1;
        want[best]--;
    }
}

/* The counts of patterns of `length` + 1 crumbs from those of `length`, which is at least 1. */
static void refine(const uint8_t *counts, int length, uint8_t base, struct cycle_dice *dice, uint8_t *finer)
{
    size_t middle_count = (size_t)1 << 2 * (length - 1);
    for (size_t u = 0; u < middle_count; u++) {
        uint8_t want[4];
        for (size_t b = 0; b < 4; b++)
            want[b] = (uint8_t)(counts[4 * u + b] - 4 * base);
        size_t first = cycle_roll(dice, 4);
        for (size_t i = 0; i < 4; i++) {
            size_t tail = (first + i) % 4 * middle_count + u;
            uint8_t row[4];
            fill_row((uint8_t)(counts[tail] - 4 * base), want, dice, row);
            for (size_t b = 0; b < 4; b++)
                finer[4 * tail + b] = (uint8_t)(base + row[b]);
        }
    }
}

static uint32_t find_part(uint32_t *part, uint32_t vertex)
{
    while (part[vertex] != vertex)
        vertex = part[vertex] = part[part[vertex]];
    return vertex;
}

/* Exchanges heads in the matrix of the middle u until its edges are of one part. */
static void join_matrix(uint8_t *edges, uint32_t u, uint32_t middle_count, uint32_t *part)
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
        uint32_t a = find_part(part, first_tail), b = find_part(part, tail);
        if (a == b)
            continue;
        /* Different parts share no edge: the two new ones were not there. */
        edges[4 * first_tail + first_head] = edges[4 * tail + head] = 0;
        edges[4 * first_tail + head] = edges[4 * tail + first_head] = 1;
        part[b] = a;
        first = first / 4 * 4 + head;
    }
}

static void join_parts(uint8_t *edges, int order, uint32_t *part)
{
    uint32_t vertices = (uint32_t)1 << 2 * order, middle_count = vertices / 4;
    for (uint32_t v = 0; v < vertices; v++)
        part[v] = v;
    for (uint32_t edge = 0; edge < 4 * vertices; edge++)
        if (edges[edge])
            part[find_part(part, edge % vertices)] = find_part(part, edge / 4);
    for (uint32_t u = 0; u < middle_count; u++)
        join_matrix(edges, u, middle_count, part);
}

enum hatch_status hatch_cycle_balance(uint32_t count, int order, struct cycle_dice *dice, struct hatch_arena *scratch,
                                      uint8_t *edges, struct hatch_err *err)
{
    size_t vertices = (size_t)1 << 2 * order;
    struct hatch_arena_mark mark = hatch_arena_mark(scratch);
    uint8_t *counts = HATCH_NEW(scratch, uint8_t, vertices < 4 ? 4 : vertices, err);
    uint32_t *part = counts ? HATCH_NEW(scratch, uint32_t, vertices, err) : NULL;
    if (!part) {
        hatch_arena_rewind(scratch, mark);
        return HATCH_LIMIT;
    }
    /* Counts over 7 never matter: only what a length is over 4 times the next one's least does. They
     * are kept modulo 256, and their differences are exact. */
    uint8_t want[4] = {1, 1, 1, 1}, extra[4];
    fill_row((uint8_t)(count % 4), want, dice, extra);
    for (int b = 0; b < 4; b++)
        edges[b] = (uint8_t)(count / 4 + extra[b]);
    for (int length = 1; length <= order; length++) {
        memcpy(counts, edges, (size_t)1 << 2 * length);
        refine(counts, length, (uint8_t)(count >> 2 * (length + 1)), dice, edges);
    }
    if (order > 0)
        join_parts(edges, order, part);
    hatch_arena_rewind(scratch, mark);
    return HATCH_OK;
}
