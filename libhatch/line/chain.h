/* Joins line segments that share nodes into chains. */
#ifndef HATCH_LINE_CHAIN_H
#define HATCH_LINE_CHAIN_H

#include <stdbool.h>

#include "base/arena.h"

struct hatch_line_graph {
    uint32_t node_count, segment_count;
    const double *nodes;  /* positions: 3 per node */
    const uint32_t *ends; /* 2 per segment: its first and last node */
};

/* A chain of segments. Chain i of struct hatch_line_chains has the segments from segments[first] and the nodes from
 * nodes[first + i]: segment_count + 1 nodes, in order. The last node of a closed chain is the first one. */
struct hatch_line_chain {
    uint32_t first, segment_count;
    bool closed;
    bool joined[2]; /* whether other segments meet its first, its last node */
};

struct hatch_line_chains {
    uint32_t count;
    struct hatch_line_chain *chains;
    uint32_t *nodes, *segments; /* indices into the graph, of all chains */
};

/* Joins segments into chains; every segment is in one chain. At a node of two segments the chain continues. At a node
 * of 3 to 16 segments these are paired, the straightest pair first; at a node of more, all chains end. Segments may
 * have no length.
 *   arena  for the chains; not the scratch arena */
enum hatch_status hatch_line_chains_make(const struct hatch_line_graph *graph, struct hatch_arena *arena,
                                         struct hatch_arena *scratch, struct hatch_line_chains *chains,
                                         struct hatch_err *err) HATCH_MUST_USE;

#endif
