/* Writes drawings for pens as stroke scripts. */
#ifndef HATCH_IO_SCRIPT_WRITE_H
#define HATCH_IO_SCRIPT_WRITE_H

#include "vector/drawing.h"

/* Writes a drawing as a script (stroke/script.h): one stroke per path, layer by layer, as hatch_svg_write orders them.
 * The tile is the page or, if that is not a square, the square around it: as long as the page's longer side, with the
 * same middle. Strokes are opaque and have the colour and the width of their layer, ids from 1 in drawing order, and
 * the id of their path as the random seed of their grain. Numbers and colours are rounded as hatch_svg_write rounds
 * them, so that hatch_svg_read reads the same strokes of the SVG document of a square page.
 *   file  in: empty; out: the script
 * HATCH_LIMIT for a pen that is wider than HATCH_SCRIPT_WIDTH_MAX tiles. */
enum hatch_status hatch_script_write(const struct hatch_drawing *drawing, struct hatch_arena *scratch,
                                     struct hatch_buffer *file, struct hatch_err *err) HATCH_MUST_USE;

#endif
