/* Writes drawings for pens as SVG. */
#ifndef HATCH_IO_SVG_WRITE_H
#define HATCH_IO_SVG_WRITE_H

#include "vector/drawing.h"

/* Writes a drawing: one group per layer, which editors show as a layer of its name, with the paths of the layer as
 * strokes. Coordinates are millimetres, rounded to 1/1000. Each path has an id that tells its layer and the number of
 * its curve: "outlines-12", and "outlines-12-2" for the second part of this curve.
 *   file  in: empty; out: the SVG document */
enum hatch_status hatch_svg_write(const struct hatch_drawing *drawing, struct hatch_arena *scratch,
                                  struct hatch_buffer *file, struct hatch_err *err) HATCH_MUST_USE;

#endif
