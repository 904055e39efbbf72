/* Joins segments that meet at nodes into chains. */
#ifndef HATCH_LINE_CHAIN_H
#define HATCH_LINE_CHAIN_H

#include <stdbool.h>

#include "base/arena.h"

/* Segment s runs from node ends[2 * s] to node ends[2 * s + 1]. */
struct hatch_line_graph {
    uint32_t node_count, segment_count;
    const double *nodes; /* 3 per node */
    const uint32_t *ends;
};

/* chain->segment_count segments are segments[first] onwards, the nodes between and around them
 * nodes[first + the chain's own number] onwards, one more than segments. A closed one ends with the
 * node with which it begins. */
struct hatch_line_chain {
    uint32_t first, segment_count;
    bool closed;
    bool joined[2]; /* other lines go on where it begins and ends */
};

struct hatch_line_chains {
    uint32_t count;
    struct hatch_line_chain *chains;
    uint32_t *nodes, *segments;
};

/* Every segment is in one chain. Where two segments meet, one chain goes through; where more meet,
 * they are paired beginning with the straightest pair. Segments without length are allowed.
 * arena and scratch must not be the same. */
enum hatch_status hatch_line_chains_make(const struct hatch_line_graph *graph, struct hatch_arena *arena,
                                         struct hatch_arena *scratch, struct hatch_line_chains *chains,
                                         struct hatch_err *err) HATCH_MUST_USE;

#endif
