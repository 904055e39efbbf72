/* Widths and ink of feature lines that a brush draws. */
#ifndef HATCH_LINE_BRUSH_H
#define HATCH_LINE_BRUSH_H

#include "curve/line_brush.h"
#include "line/strip.h"
#include "scene/unit_scene.h"

/* Computes how a brush touches the picture along strips. Width and ink vary with the place on the item, so
 * that lines are steady from frame to frame.
 *   item     that the strips belong to
 *   size     of the item's mesh, in mesh units, over 0: half the diagonal of its box
 *   visible  per piece, from hatch_line_strips_smooth
 *   seen     per piece: bits of enum hatch_line_seen
 *   touches  out: in arena, one per piece */
enum hatch_status hatch_line_brush_touch(const struct hatch_line_brush *brush, const struct hatch_item *item,
                                         double size, const struct hatch_line_strips *strips, const uint8_t *visible,
                                         const uint8_t *seen, struct hatch_arena *arena,
                                         struct hatch_line_touch **touches, struct hatch_err *err) HATCH_MUST_USE;

#endif
