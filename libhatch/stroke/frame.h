/* A stroke in the pixels of one image: what of it covers a place that lies so far along and across it.
 * Private to stroke. */
#ifndef HATCH_STROKE_FRAME_H
#define HATCH_STROKE_FRAME_H

#include "stroke/brush.h"

struct hatch_frame {
    float centre_x, centre_y;
    float cosine, sine;
    float radius;                  /* px, of an arc; its sign is the bend's; 0: straight */
    float half_length, half_width; /* px */
    float core;                    /* px: half of the line that round ends are put to */
    float per_length, per_width;   /* 1 / px: to 0..1 along and across */
    float columns;                 /* of the brush image */
    float columns_per_px;
    float opacity;
    float tone; /* times the width: what a difference of two sums is to become */
    uint32_t grain_x, grain_y;
};

/* The arguments are those of hatch_footprint_draw. */
struct hatch_frame hatch_frame_of(const struct hatch_stroke *stroke, const struct hatch_brush *brush, uint32_t size_px,
                                  float length_scale, float width_scale);

/* The alpha of the pixel whose middle lies at (along, across) px from the stroke's middle. */
float hatch_frame_alpha(const struct hatch_frame *frame, const struct hatch_brush *brush, float along, float across);

/* Narrows [*low, *high] to the x for which |a x + b| <= reach; *low > *high where there is none. */
void hatch_frame_clip(float a, float b, float reach, float *low, float *high);

/* A place of the plane on a torus of size pixels. */
static inline uint32_t hatch_frame_wrap(int32_t at, uint32_t size)
{
    int32_t rest = at % (int32_t)size;
    return (uint32_t)(rest < 0 ? rest + (int32_t)size : rest);
}

struct hatch_footprint;

/* hatch_footprint_draw for a stroke with a path. */
void hatch_footprint_draw_path(const struct hatch_stroke *stroke, const struct hatch_brush *brush,
                               const struct hatch_frame *frame, uint32_t size_px, struct hatch_footprint *footprint);

#endif
