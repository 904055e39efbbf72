/* Stroke scripts: strokes as tab-separated text with a header line, in drawing order. Columns: x y length angle width
 * tone r g b, and optionally id, column, level, grain (texture_seed), bend, enters (first column that holds the stroke
 * on each level, finest first, as in "3,3,5") and path (points "x,y x,y" from the stroke's middle). Lengths are
 * fractions of the tile, width at its finest level; angles are radians. Printed scripts parse to the same strokes. */
#ifndef HATCH_STROKE_SCRIPT_H
#define HATCH_STROKE_SCRIPT_H

#include "base/bytes.h"
#include "stroke/stroke.h"

#define HATCH_SCRIPT_WIDTH_MAX 4.0 /* tiles */

/* Appends strokes as a script to text.
 *   size_px  width and height of the finest level, to convert width_px to a fraction
 *   comment  one line; NULL: none */
enum hatch_status hatch_script_print(const struct hatch_stroke *strokes, uint32_t count, uint32_t size_px,
                                     const char *comment, struct hatch_buffer *text,
                                     struct hatch_err *err) HATCH_MUST_USE;

/* Parses a script. Columns may come in any order, unknown ones are ignored, missing optional ones are 0; positions are
 * wrapped into the tile.
 *   size_px  as for hatch_script_print
 *   strokes  out, in arena; unchanged on failure
 * HATCH_BAD_INPUT for a missing or repeated column and, naming the line, for a wrong number of fields, a field that is
 * not a number, or a value out of range. */
enum hatch_status hatch_script_parse(struct hatch_bytes text, uint32_t size_px, struct hatch_arena *arena,
                                     struct hatch_stroke_list *strokes, struct hatch_err *err) HATCH_MUST_USE;

#endif
