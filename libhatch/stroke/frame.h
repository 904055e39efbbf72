/* Stroke frames: a stroke in the pixels of one image, and its alpha at a position along and across it.
 * Private to stroke. */
#ifndef HATCH_STROKE_FRAME_H
#define HATCH_STROKE_FRAME_H

#include "stroke/brush.h"

struct hatch_frame {
    float centre_x, centre_y;      /* px */
    float cosine, sine;            /* of the stroke's direction */
    double radius;                 /* px, of an arc, negative for a negative bend; 0: straight */
    float half_length, half_width; /* px */
    float core; /* px: half the length of the centre line; a round brush has its caps at the ends of this line */
    float per_length, per_width; /* 1 / px: converts px to 0 .. 1 along and across */
    float columns;               /* width of the brush image */
    float columns_per_px;        /* brush columns per pixel */
    float opacity;               /* of the stroke, 0 .. 1 */
    float alpha_per_width;       /* converts a difference of cumulative alphas to the alpha of a pixel */
    uint32_t grain_x, grain_y;   /* offset into the grain, px */
    float grain_half[2]; /* px: half the length and the width at scale 1, so that the grain stays as a stroke grows */
};

/* Makes the frame of a stroke; arguments as for hatch_footprint_draw. */
struct hatch_frame hatch_frame_make(const struct hatch_stroke *stroke, const struct hatch_brush *brush,
                                    uint32_t size_px, float length_scale, float width_scale);

/* Returns the alpha of the pixel whose centre lies at (along, across) px from the middle of the stroke: coverage,
 * brush and grain, box-filtered over the pixel. */
float hatch_frame_alpha(const struct hatch_frame *frame, const struct hatch_brush *brush, float along, float across);

/* Narrows *low .. *high to the x for which |a x + b| <= reach; *low > *high if there are none. */
void hatch_frame_clip(float a, float b, float reach, float *low, float *high);

/* Wraps a pixel coordinate on a torus of size pixels. */
static inline uint32_t hatch_frame_wrap(int32_t at, uint32_t size)
{
    int32_t rest = at % (int32_t)size;
    return (uint32_t)(rest < 0 ? rest + (int32_t)size : rest);
}

struct hatch_footprint;

/* Rasterises a stroke with a path; see hatch_footprint_draw. */
void hatch_footprint_draw_path(const struct hatch_stroke *stroke, const struct hatch_brush *brush,
                               const struct hatch_frame *frame, uint32_t size_px, struct hatch_footprint *footprint);

#endif
