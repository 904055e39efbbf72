/* Which pixels of a square toroidal image a stroke covers, and how much of each. */
#ifndef HATCH_STROKE_FOOTPRINT_H
#define HATCH_STROKE_FOOTPRINT_H

#include "stroke/brush.h"

/* One pixel each, every pixel at most once, in row order of the unwrapped stroke. Owned by the arena
 * that hatch_footprint_make was given; refilled by each hatch_footprint_draw. */
struct hatch_footprint {
    uint32_t count, capacity;
    uint32_t *at;       /* y * size + x */
    float *alpha;       /* 0 .. 1: coverage × brush × tone */
    float *along;       /* 0 .. 1 from the stroke's start to its end */
    uint32_t *entry_of; /* private: zeros, one for each pixel of the largest image */
};

/* Room for any stroke up to the given length (fraction of the tile) and width on images up to size_px
 * squared. */
enum hatch_status hatch_footprint_make(struct hatch_arena *arena, uint32_t size_px, float length, float width_px,
                                       struct hatch_footprint *footprint, struct hatch_err *err) HATCH_MUST_USE;

/* Rasterises with a one-pixel box filter across and along, so that edges are anti-aliased and a
 * stroke thinner than a pixel keeps its ink. length_scale and width_scale: 0 .. 1, for strokes that
 * grow (1 is the whole stroke). A stroke longer than the tile that meets itself counts its darkest
 * coverage once. size_px: 1 .. the size that footprint was made for. */
void hatch_footprint_draw(const struct hatch_stroke *stroke, const struct hatch_brush *brush, uint32_t size_px,
                          float length_scale, float width_scale, struct hatch_footprint *footprint);

/* Turns the alphas of `now` into what must be laid over `before`, multiplying, to make `now`: 1 - (1 -
 * now) / (1 - before), at least 0. Both on one image size. */
void hatch_footprint_remove(struct hatch_footprint *now, const struct hatch_footprint *before);

#endif
