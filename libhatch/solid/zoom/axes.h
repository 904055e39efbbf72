/* Private to solid/zoom: colours in coordinates along their principal components. */
#ifndef HATCH_SOLID_ZOOM_AXES_H
#define HATCH_SOLID_ZOOM_AXES_H

#include "solid/zoom.h"

/* Converts the texels of a coloured texture to such coordinates, 0 .. 1.
 *   zoom  out: base, in arena; offset and axes
 * HATCH_LIMIT when the memory does not suffice. */
enum hatch_status hatch_zoom_turn(const struct hatch_solid *solid, struct hatch_arena *arena, struct hatch_zoom *zoom,
                                  struct hatch_err *err) HATCH_MUST_USE;

#endif
