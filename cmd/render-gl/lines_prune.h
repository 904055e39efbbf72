/* Tells creases that were meant from those that noise makes. */
#ifndef RENDER_LINES_PRUNE_H
#define RENDER_LINES_PRUNE_H

#include "render-gl/lines_chain.h"

/* Finds segments to leave out. Creases that end nowhere and are short (in segments, or against the
 * whole's size) or crooked, and then those that hung on these: a scanned or coarse surface has many
 * single edges over any angle, while an edge that somebody modelled goes on, closes, or ends at others.
 * Small loops of creases around a fold of a few faces. Loops without area, which are cracks where a
 * face's corner lies on another face's side.
 * bounds: per segment, not 0: it is a boundary, which only a crack can be left out as. size: of the
 * whole, in the nodes' units. pruned: per segment, set to 1 where it is to go. */
enum hatch_status line_prune(const struct line_graph *graph, const uint8_t *bounds, double size,
                             struct hatch_arena *arena, struct hatch_arena *scratch,
                             uint8_t *pruned, struct hatch_err *err) HATCH_MUST_USE;

#endif
