/* Brushes: the alpha of a stroke over (along, across), as a grey image. Praun et al. 2001, §4: "choice of stroke
 * (given as a grayscale image)". */
#ifndef HATCH_STROKE_BRUSH_H
#define HATCH_STROKE_BRUSH_H

#include "image/image.h"
#include "stroke/stroke.h"

enum hatch_brush_kind {
    HATCH_BRUSH_INK,      /* full alpha, tapered ends */
    HATCH_BRUSH_PENCIL,   /* soft across, fine grain along */
    HATCH_BRUSH_CRAYON,   /* coarse grain, ragged edge */
    HATCH_BRUSH_CHARCOAL, /* broad, very grainy, soft edge */
    HATCH_BRUSH_STIPPLE,  /* full alpha, for dots */
    HATCH_BRUSH_ROUND,    /* full alpha, half discs at the ends: the round caps of drawing programs */
    HATCH_BRUSH_IMAGE     /* a grey image that the user supplies */
};

#define HATCH_GRAIN_SIZE 64u

struct hatch_brush {
    enum hatch_brush_kind kind;
    uint32_t width, height;
    float *alpha;      /* [y * width + x], 0 .. 1: x runs along the stroke from start to end, y across it */
    float *cumulative; /* [x * (height + 1) + y]: sum of alpha over rows 0 .. y - 1, divided by height */
    float *grain; /* factor for alpha, 0 .. 1: a repeating square with a side of HATCH_GRAIN_SIZE pixels of the image
                     drawn on, at an offset chosen by the stroke's texture_seed; NULL: none */
};

/* Returns "ink", "pencil" and so on; NULL for HATCH_BRUSH_IMAGE. */
const char *hatch_brush_name(enum hatch_brush_kind kind);

/* Makes a built-in brush, the same on every machine.
 *   kind   any but HATCH_BRUSH_IMAGE
 *   brush  out, in arena */
enum hatch_status hatch_brush_make(enum hatch_brush_kind kind, struct hatch_arena *arena, struct hatch_brush *brush,
                                   struct hatch_err *err) HATCH_MUST_USE;

/* Makes a brush from an image: alpha is the A channel if that varies, else 1 - luminance (dark is ink).
 *   brush  out, in arena; unchanged on failure
 * HATCH_BAD_INPUT when no pixel holds ink. */
enum hatch_status hatch_brush_from_image(const struct hatch_image *image, struct hatch_arena *arena,
                                         struct hatch_brush *brush, struct hatch_err *err) HATCH_MUST_USE;

#endif
