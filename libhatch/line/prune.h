/* Removes edges from the feature lines that are due to noise or to cracks (T-junctions), or that are boundaries within
 * other faces. */
#ifndef HATCH_LINE_PRUNE_H
#define HATCH_LINE_PRUNE_H

#include "line/edges.h"

/* Finds creases to remove: chains with a free end that are short (in segments, or relative to the mesh) or crooked;
 * then chains whose ends became free by this; and small isolated loops of fewer than four segments. On scanned or
 * coarse surfaces single edges may exceed any angle, whereas a modelled crease continues, closes, ends at others, or is
 * the edge between two planes, which one segment may be long enough for.
 *   bounds  per segment: not 0: a boundary, which is kept
 *   flat    per segment: not 0: it lies between two planes, each of several faces; chains of such segments may have few
 *   size    of the mesh, in units of the nodes
 *   pruned  per segment, in and out: 1: removed */
enum hatch_status hatch_line_prune(const struct hatch_line_graph *graph, const uint8_t *bounds, const uint8_t *flat,
                                   double size, struct hatch_arena *arena, struct hatch_arena *scratch, uint8_t *pruned,
                                   struct hatch_err *err) HATCH_MUST_USE;

/* Finds cracks (T-junctions), where boundaries coincide: a long edge on one side, and a straight path of shorter edges
 * between the same ends on the other.
 *   bounds  per segment: not 0: a boundary
 *   pruned  per segment: set to 1 for segments of a crack */
enum hatch_status hatch_line_find_cracks(const struct hatch_line_graph *graph, const uint8_t *bounds,
                                         struct hatch_arena *scratch, uint8_t *pruned,
                                         struct hatch_err *err) HATCH_MUST_USE;

/* Makes boundaries smooth edges if they lie within other faces at both ends. */
enum hatch_status hatch_line_drop_covered(const struct hatch_mesh *mesh, struct hatch_arena *scratch,
                                          struct hatch_line_edges *edges, struct hatch_err *err) HATCH_MUST_USE;

#endif
