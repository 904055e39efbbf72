/* Tells edges that were meant from those that noise and untidy faces make. */
#ifndef HATCH_LINE_PRUNE_H
#define HATCH_LINE_PRUNE_H

#include "line/edges.h"

/* Finds creases to leave out: those that end nowhere and are short (in segments, or against the
 * whole's size) or crooked, and then those that hung on these; and loops of two or three segments. A
 * scanned or coarse surface has many single edges over any angle, while an edge that somebody modelled
 * goes on, closes, or ends at others.
 * bounds: per segment, not 0: it is a boundary and stays. size: of the whole, in the nodes' units.
 * pruned: per segment; where it is set already the segment counts as gone; set to 1 where it is to go. */
enum hatch_status hatch_line_prune(const struct hatch_line_graph *graph, const uint8_t *bounds, double size,
                                   struct hatch_arena *arena, struct hatch_arena *scratch, uint8_t *pruned,
                                   struct hatch_err *err) HATCH_MUST_USE;

/* Finds boundaries that lie on one another: a corner of one face on the side of another makes a gap
 * without width, of one long edge and the straight path of short ones between its ends.
 * bounds: per segment, not 0: it is a boundary. pruned: per segment, set to 1 where it is such a crack. */
enum hatch_status hatch_line_find_cracks(const struct hatch_line_graph *graph, const uint8_t *bounds,
                                         struct hatch_arena *scratch, uint8_t *pruned,
                                         struct hatch_err *err) HATCH_MUST_USE;

/* Makes boundaries smooth that run within other faces at both their ends. */
enum hatch_status hatch_line_drop_covered(const struct hatch_mesh *mesh, struct hatch_arena *scratch,
                                          struct hatch_line_edges *edges, struct hatch_err *err) HATCH_MUST_USE;

#endif
