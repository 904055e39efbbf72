/* What a stroke looks like: its alpha over (along, across), as a grey image. Praun et al. 2001, §4:
 * "choice of stroke (given as a grayscale image)". */
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
    HATCH_BRUSH_ROUND,    /* full alpha, a half disc at each end: what drawing programs call a round cap */
    HATCH_BRUSH_IMAGE     /* the user's grey image */
};

#define HATCH_GRAIN_SIZE 64u

/* alpha[y * width + x] in 0..1: x runs along the stroke from start to end, y across it: the envelope.
 * The grain is a toroidal square of HATCH_GRAIN_SIZE pixels at the drawn scale, which multiplies the
 * envelope and starts at a place that the stroke's texture_seed picks; NULL where there is none. */
struct hatch_brush {
    enum hatch_brush_kind kind;
    uint32_t width, height;
    float *alpha;
    float *cumulative; /* [x * (height + 1) + y]: the sum of alpha over rows 0 .. y-1, over height */
    float *grain;
};

/* "ink", "pencil" and so on; NULL for HATCH_BRUSH_IMAGE. */
const char *hatch_brush_name(enum hatch_brush_kind kind);

/* A built-in brush, the same on every machine. kind: any but HATCH_BRUSH_IMAGE, which is made from an image. Its
 * arrays live in arena. */
enum hatch_status hatch_brush_make(enum hatch_brush_kind kind, struct hatch_arena *arena, struct hatch_brush *brush,
                                   struct hatch_err *err) HATCH_MUST_USE;

/* From a grey image: alpha = 1 - Y (dark is ink), or the A channel where there is one that varies.
 * Colour is turned to luminance. HATCH_BAD_INPUT when no pixel holds ink. */
enum hatch_status hatch_brush_from_image(const struct hatch_image *image, struct hatch_arena *arena,
                                         struct hatch_brush *brush, struct hatch_err *err) HATCH_MUST_USE;

#endif
