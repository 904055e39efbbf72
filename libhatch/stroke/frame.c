#include "stroke/frame.h"

#include "base/random.h"

#define CAP_SAMPLES 8u
#define SAGITTA_MIN (1.0 / 64) /* px: least distance of the middle of an arc from its chord */

/* Returns the radius of an arc, px; 0: the stroke is drawn straight. */
static double radius_of(const struct hatch_stroke *stroke, uint32_t size_px)
{
    double length_px = (double)stroke->length * size_px, bend = (double)stroke->bend_rad;
    return !stroke->path && length_px * fabs(bend) / 8 >= SAGITTA_MIN ? length_px / bend : 0;
}

struct hatch_frame hatch_frame_make(const struct hatch_stroke *stroke, const struct hatch_brush *brush,
                                    uint32_t size_px, float length_scale, float width_scale)
{
    struct hatch_frame f;
    f.centre_x = stroke->x * (float)size_px;
    f.centre_y = stroke->y * (float)size_px;
    f.cosine = (float)cos((double)stroke->angle_rad);
    f.sine = (float)sin((double)stroke->angle_rad);
    f.half_width = stroke->width_px * width_scale * 0.5f;
    f.half_length = stroke->length * (float)size_px * length_scale * 0.5f;
    f.grain_half[1] = stroke->width_px * 0.5f;
    f.grain_half[0] = fmaxf(stroke->length * (float)size_px * 0.5f, f.grain_half[1]);
    f.radius = radius_of(stroke, size_px);
    /* Caps extend a path beyond its end points; the length of other strokes includes them. */
    f.core = f.half_length - (stroke->path ? 0 : f.half_width);
    f.core = f.core > 0 ? f.core : 0;
    if (f.half_length < f.half_width)
        f.half_length = f.half_width;
    f.per_length = 0.5f / f.half_length;
    f.per_width = 0.5f / f.half_width;
    f.columns = (float)brush->width;
    f.columns_per_px = f.columns * f.per_length;
    f.opacity = stroke->tone;
    f.alpha_per_width = stroke->tone * 2 * f.half_width;
    uint64_t offset = brush->grain ? hatch_random_u64(stroke->texture_seed, 7, 0) : 0;
    f.grain_x = (uint32_t)(offset % HATCH_GRAIN_SIZE);
    f.grain_y = (uint32_t)(offset / HATCH_GRAIN_SIZE % HATCH_GRAIN_SIZE);
    return f;
}

/* Returns the integral of alpha over a brush column from the edge of the stroke to `across`, a share of its width. It
 * is exact when brush pixels are taken as boxes. */
static float cumulative_at(const float *column, uint32_t height, float across)
{
    if (across <= 0)
        return 0;
    if (across >= 1)
        return column[height];
    float row = across * (float)height;
    uint32_t below = (uint32_t)row;
    return column[below] + (column[below + 1] - column[below]) * (row - (float)below);
}

static float grain_at(const struct hatch_brush *brush, const struct hatch_frame *f, float along, float across)
{
    /* Nearest neighbour, because interpolation would blur the grain. */
    uint32_t x = (uint32_t)(int32_t)floorf(along + f->grain_half[0]) + f->grain_x;
    uint32_t y = (uint32_t)(int32_t)floorf(across + f->grain_half[1]) + f->grain_y;
    return brush->grain[y % HATCH_GRAIN_SIZE * HATCH_GRAIN_SIZE + x % HATCH_GRAIN_SIZE];
}

/* Returns the integral of alpha over one column of the brush between two positions across. */
static float column_coverage(const struct hatch_brush *brush, uint32_t x, float from, float to)
{
    const float *column = brush->cumulative + (size_t)x * (brush->height + 1);
    return cumulative_at(column, brush->height, to) - cumulative_at(column, brush->height, from);
}

/* Returns the brush's alpha, integrated across a pixel, times the pixel's coverage along the stroke. If brush columns
 * are smaller than pixels, it averages those within the pixel, because a single one would lose or double ink; otherwise
 * it uses the column at the centre of the pixel. */
static float pixel_coverage(const struct hatch_brush *brush, const struct hatch_frame *f, float along, float from,
                            float to)
{
    float position = (along * f->per_length + 0.5f) * f->columns;
    if (f->columns_per_px <= 1) {
        float inside = f->half_length - fabsf(along) + 0.5f;
        uint32_t x = position <= 0 ? 0 : position < f->columns ? (uint32_t)position : brush->width - 1;
        return column_coverage(brush, x, from, to) * (inside < 1 ? inside : 1);
    }
    float low = position - 0.5f * f->columns_per_px, high = position + 0.5f * f->columns_per_px, sum = 0;
    low = low > 0 ? low : 0;
    high = high < f->columns ? high : f->columns;
    for (uint32_t x = (uint32_t)low; (float)x < high; x++) {
        float left = low > (float)x ? low : (float)x, right = high < (float)x + 1 ? high : (float)x + 1;
        sum += (right - left) * column_coverage(brush, x, from, to);
    }
    return sum / f->columns_per_px;
}

/* Returns the share of a pixel's extent across the stroke that lies within half_width of the centre line. */
static float chord(float across, float half_width)
{
    float low = across - 0.5f > -half_width ? across - 0.5f : -half_width;
    float high = across + 0.5f < half_width ? across + 0.5f : half_width;
    return high > low ? high - low : 0;
}

/* Returns the coverage of a pixel by a line with half discs at its ends. Pixels at an end are cut into slices, so that
 * the coverages sum to the area even for thin lines. */
static float round_coverage(const struct hatch_frame *f, float along, float across)
{
    along = fabsf(along);
    if (along + 0.5f <= f->core)
        return chord(across, f->half_width);
    if (along - 0.5f >= f->core + f->half_width)
        return 0;
    float sum = 0;
    for (uint32_t i = 0; i < CAP_SAMPLES; i++) {
        float at = along + ((float)i + 0.5f) / (float)CAP_SAMPLES - 0.5f, beyond = fabsf(at) - f->core;
        float square = f->half_width * f->half_width - (beyond > 0 ? beyond * beyond : 0);
        if (square > 0)
            sum += chord(across, sqrtf(square));
    }
    return sum / (float)CAP_SAMPLES;
}

float hatch_frame_alpha(const struct hatch_frame *f, const struct hatch_brush *brush, float along, float across)
{
    if (brush->kind == HATCH_BRUSH_ROUND)
        return round_coverage(f, along, across) * f->opacity;
    if (fabsf(along) >= f->half_length + 0.5f)
        return 0;
    float from = (across - 0.5f) * f->per_width + 0.5f, to = (across + 0.5f) * f->per_width + 0.5f;
    float alpha = pixel_coverage(brush, f, along, from, to) * f->alpha_per_width;
    if (brush->grain && alpha > 0)
        alpha *= grain_at(brush, f, along, across);
    return alpha > 1 ? 1 : alpha;
}

void hatch_frame_clip(float a, float b, float reach, float *low, float *high)
{
    if (fabsf(a) < 1e-6f) {
        if (fabsf(b) > reach)
            *high = *low - 1;
        return;
    }
    float first = (-reach - b) / a, second = (reach - b) / a;
    float from = first < second ? first : second, to = first < second ? second : first;
    *low = from > *low ? from : *low;
    *high = to < *high ? to : *high;
}
