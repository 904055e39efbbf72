/* Stroke scripts: strokes as text, TSV with a header line: x y length angle width tone r g b, and
 * optionally id column level grain (the seed of its texture), bend, enters (the column in which each level
 * first has it, finest first, "3,3,5") and path ("x,y x,y" from its middle, of a drawn line); fractions of
 * the tile and radians; width as a fraction of the tile at its finest size. In drawing order. What is
 * printed reads back exactly. */
#ifndef HATCH_STROKE_SCRIPT_H
#define HATCH_STROKE_SCRIPT_H

#include "base/bytes.h"
#include "stroke/stroke.h"

/* size_px: the finest size, which turns width_px into a fraction. comment: one line, or NULL. */
enum hatch_status hatch_script_print(const struct hatch_stroke *strokes, uint32_t count, uint32_t size_px,
                                     const char *comment, struct hatch_buffer *text,
                                     struct hatch_err *err) HATCH_MUST_USE;

/* Columns may come in any order, unknown ones are passed over, missing optional ones are 0; centres are
 * wrapped into the tile. HATCH_BAD_INPUT for a missing or doubled column, and with the line for a wrong
 * number of fields, a field that is no number or not finite, or a value out of range. */
enum hatch_status hatch_script_parse(struct hatch_bytes text, uint32_t size_px, struct hatch_arena *arena,
                                     struct hatch_stroke_list *strokes, struct hatch_err *err) HATCH_MUST_USE;

#endif
