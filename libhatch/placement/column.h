/* The images of a canvas as one column of a tonal art map, handed to a sink. Private to tam. */
#ifndef HATCH_TAM_COLUMN_H
#define HATCH_TAM_COLUMN_H

#include "placement/canvas.h"
#include "placement/fill.h"

/* What a file says of the whole map; seed's digits live in arena: a sink may keep a column's attributes
 * longer than its pixels. */
enum hatch_status hatch_column_label(const struct hatch_style *style, uint32_t levels, uint64_t seed, float growth,
                                     struct hatch_arena *arena, struct hatch_tam_label *label,
                                     struct hatch_err *err) HATCH_MUST_USE;

/* The canvas's levels are the column's own, the rest is box-filtered. */
enum hatch_status hatch_column_deliver(const struct hatch_canvas *canvas, const struct hatch_tam_label *label,
                                       uint32_t tone, float target, struct hatch_arena *scratch, hatch_tam_sink sink,
                                       void *context, struct hatch_err *err) HATCH_MUST_USE;

#endif
