/* Footprints: the pixels of a square toroidal image that a stroke covers, with their alpha. */
#ifndef HATCH_STROKE_FOOTPRINT_H
#define HATCH_STROKE_FOOTPRINT_H

#include "stroke/brush.h"

/* One entry per covered pixel; no pixel occurs twice. The arrays are in the arena of hatch_footprint_make and are
 * overwritten by each hatch_footprint_draw. */
struct hatch_footprint {
    uint32_t count, capacity;
    uint32_t *at;       /* y * size + x */
    float *alpha;       /* 0 .. 1: coverage × brush × grain × opacity */
    float *along;       /* 0 .. 1 from the stroke's start to its end */
    uint32_t *entry_of; /* private: per pixel of the largest image, zero between calls */
};

/* Makes room for the footprints of strokes up to a size.
 *   size_px    largest width and height of the image
 *   length     of the longest stroke, in tiles
 *   width_px   of the widest stroke
 *   footprint  out, in arena
 * HATCH_LIMIT when memory does not suffice. */
enum hatch_status hatch_footprint_make(struct hatch_arena *arena, uint32_t size_px, float length, float width_px,
                                       struct hatch_footprint *footprint, struct hatch_err *err) HATCH_MUST_USE;

/* Rasterises a stroke with a box filter of one pixel along and across, so that edges are anti-aliased and a stroke
 * thinner than a pixel keeps its ink. A pixel that the stroke covers more than once around the torus gets its largest
 * alpha; a path gives it the alpha of its nearest part. An arc whose middle is less than 1/64 px from its chord is
 * drawn as a line.
 *   size_px                    width and height of the image, 1 .. that of hatch_footprint_make
 *   length_scale, width_scale  0 .. 1; 1 is the full stroke
 *   footprint                  out */
void hatch_footprint_draw(const struct hatch_stroke *stroke, const struct hatch_brush *brush, uint32_t size_px,
                          float length_scale, float width_scale, struct hatch_footprint *footprint);

/* Replaces the alphas of `now` by those that, composited over `before`, yield `now`: max(0, 1 - (1 - now) / (1 -
 * before)). Both must be footprints on the same image size. */
void hatch_footprint_subtract(struct hatch_footprint *now, const struct hatch_footprint *before);

#endif
