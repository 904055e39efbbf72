/* Hands the images of a canvas to a sink as one column of a tonal art map. Private to placement. */
#ifndef HATCH_PLACEMENT_COLUMN_H
#define HATCH_PLACEMENT_COLUMN_H

#include "placement/canvas.h"
#include "tam/sink.h"
#include "tam/tam.h"

/* Collects the metadata of a map.
 *   seed      random seed
 *   growth    of struct hatch_fill_options
 *   arena     receives seed as text; it must outlive the attributes, which a sink may keep longer than the pixels
 *   metadata  out: refers to style */
enum hatch_status hatch_column_metadata(const struct hatch_style *style, uint32_t tones, uint32_t levels, uint64_t seed,
                                        float growth, struct hatch_arena *arena, struct hatch_tam_metadata *metadata,
                                        struct hatch_err *err) HATCH_MUST_USE;

/* Completes the mip chain below the drawn levels by box filtering and calls sink.
 *   tone     index of the column
 *   target   target tone of the column
 *   strokes  stored with it, as a script; NULL: none
 *   arena    receives the script; it must outlive the attributes
 * The status of sink; HATCH_LIMIT when memory does not suffice. */
enum hatch_status hatch_column_deliver(const struct hatch_canvas *canvas, const struct hatch_tam_metadata *metadata,
                                       uint32_t tone, float target, const struct hatch_stroke_list *strokes,
                                       struct hatch_arena *arena, struct hatch_arena *scratch,
                                       const struct hatch_tam_sink *sink, struct hatch_err *err) HATCH_MUST_USE;

#endif
