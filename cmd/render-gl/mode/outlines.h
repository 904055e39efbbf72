/* The feature lines of a posed scene as curves, for drawings by a pen. */
#ifndef RENDER_MODE_OUTLINES_H
#define RENDER_MODE_OUTLINES_H

#include "line/lines.h"
#include "vector/curves.h"

/* Traces the feature lines; curves are numbered from 1, creases and boundaries first: their number is the same in all
 * views. Silhouettes without a step in depth (vector/step.h) are hidden.
 *   arena   for the curves
 *   curves  out: of layer 0 */
enum hatch_status outlines_trace(const struct hatch_lines *lines, const struct hatch_view *view, double height_px,
                                 const struct hatch_occluders *occluders, struct hatch_arena *arena,
                                 struct hatch_vector_curves *curves, struct hatch_err *err) HATCH_MUST_USE;

#endif
