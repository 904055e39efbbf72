#include "stroke/footprint.h"

#include <assert.h>
#include <math.h>

#include "base/random.h"

/* The stroke in the pixels of one image. */
struct frame {
    float centre_x, centre_y;
    float cosine, sine;
    float half_length, half_width; /* px */
    float per_length, per_width;   /* 1 / px: to 0..1 along and across */
    float columns;                 /* of the brush image */
    float columns_per_px;
    float tone;                    /* times the width: what a difference of two sums is to become */
    uint32_t grain_x, grain_y;
};

enum hatch_status hatch_footprint_make(struct hatch_arena *arena, uint32_t size_px, float length,
                                       float width_px, struct hatch_footprint *footprint,
                                       struct hatch_err *err)
{
    struct hatch_footprint made = {0};
    double reach = (double)length * size_px + (double)width_px + 4;
    double across = (double)width_px + 4;
    double pixels = reach * across * 2 + reach * 4 + 64;
    if (!(pixels < UINT32_MAX / 2))
        return hatch_fail(err, HATCH_LIMIT, "stroke of %g pixels is too large", pixels);
    made.capacity = (uint32_t)pixels;
    made.at = HATCH_NEW(arena, uint32_t, made.capacity, err);
    made.alpha = HATCH_NEW(arena, float, made.capacity, err);
    made.along = HATCH_NEW(arena, float, made.capacity, err);
    made.entry_of = HATCH_NEW(arena, uint32_t, (size_t)size_px * size_px, err);
    if (!made.at || !made.alpha || !made.along || !made.entry_of)
        return HATCH_LIMIT;
    *footprint = made;
    return HATCH_OK;
}

static struct frame frame_of(const struct hatch_stroke *stroke, const struct hatch_brush *brush,
                             uint32_t size_px, float length_scale, float width_scale)
{
    struct frame f;
    f.centre_x = stroke->x * (float)size_px;
    f.centre_y = stroke->y * (float)size_px;
    f.cosine = (float)cos((double)stroke->angle_rad);
    f.sine = (float)sin((double)stroke->angle_rad);
    f.half_width = stroke->width_px * width_scale * 0.5f;
    f.half_length = stroke->length * (float)size_px * length_scale * 0.5f;
    if (f.half_length < f.half_width)
        f.half_length = f.half_width;
    f.per_length = 0.5f / f.half_length;
    f.per_width = 0.5f / f.half_width;
    f.columns = (float)brush->width;
    f.columns_per_px = f.columns * f.per_length;
    f.tone = stroke->tone * 2 * f.half_width;
    uint64_t place = brush->grain ? hatch_random_u64(stroke->texture_seed, 7, 0) : 0;
    f.grain_x = (uint32_t)(place % HATCH_GRAIN_SIZE);
    f.grain_y = (uint32_t)(place / HATCH_GRAIN_SIZE % HATCH_GRAIN_SIZE);
    return f;
}

/* The sum of alpha from the stroke's edge to `across` (0..1 of the width), by linear interpolation:
 * exact for a brush image whose pixels are boxes. */
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

static float grain_at(const struct hatch_brush *brush, const struct frame *f, float along, float across)
{
    /* Half-pixel steps would blur the tooth away: nearest is what a rough paper looks like. */
    uint32_t x = (uint32_t)(int32_t)floorf(along + f->half_length) + f->grain_x;
    uint32_t y = (uint32_t)(int32_t)floorf(across + f->half_width) + f->grain_y;
    return brush->grain[y % HATCH_GRAIN_SIZE * HATCH_GRAIN_SIZE + x % HATCH_GRAIN_SIZE];
}

/* What one column of the brush covers between two places across. */
static float covered_by(const struct hatch_brush *brush, uint32_t x, float from, float to)
{
    const float *column = brush->cumulative + (size_t)x * (brush->height + 1);
    return cumulative_at(column, brush->height, to) - cumulative_at(column, brush->height, from);
}

/* The same, times the coverage along. Where pixels are smaller than columns the column under the pixel's
 * centre is taken, else the mean of all that lie in the pixel: taking one of many would lose or double
 * the ink of a stroke drawn small. */
static float covered_around(const struct hatch_brush *brush, const struct frame *f, float along, float from,
                            float to)
{
    float place = (along * f->per_length + 0.5f) * f->columns;
    if (f->columns_per_px <= 1) {
        float inside = f->half_length - fabsf(along) + 0.5f;
        uint32_t x = place <= 0 ? 0 : place < f->columns ? (uint32_t)place : brush->width - 1;
        return covered_by(brush, x, from, to) * (inside < 1 ? inside : 1);
    }
    float low = place - 0.5f * f->columns_per_px, high = place + 0.5f * f->columns_per_px, sum = 0;
    low = low > 0 ? low : 0;
    high = high < f->columns ? high : f->columns;
    for (uint32_t x = (uint32_t)low; (float)x < high; x++) {
        float left = low > (float)x ? low : (float)x, right = high < (float)x + 1 ? high : (float)x + 1;
        sum += (right - left) * covered_by(brush, x, from, to);
    }
    return sum / f->columns_per_px;
}

/* Coverage × envelope × grain at (along, across) px from the centre, box-filtered over a pixel. */
static float alpha_at(const struct hatch_brush *brush, const struct frame *f, float along, float across)
{
    if (fabsf(along) >= f->half_length + 0.5f)
        return 0;
    float from = (across - 0.5f) * f->per_width + 0.5f, to = (across + 0.5f) * f->per_width + 0.5f;
    float alpha = covered_around(brush, f, along, from, to) * f->tone;
    if (brush->grain && alpha > 0)
        alpha *= grain_at(brush, f, along, across);
    return alpha > 1 ? 1 : alpha;
}

static uint32_t wrap(int32_t at, uint32_t size)
{
    int32_t rest = at % (int32_t)size;
    return (uint32_t)(rest < 0 ? rest + (int32_t)size : rest);
}

/* Narrows [*low, *high] to the x for which |a x + b| <= reach. */
static void clip_row(float a, float b, float reach, float *low, float *high)
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

static void draw_row(const struct hatch_brush *brush, const struct frame *f, uint32_t size_px, int32_t y,
                     float reach_x, struct hatch_footprint *out)
{
    float dy = (float)y + 0.5f - f->centre_y;
    float low = -reach_x, high = reach_x; /* dx from the centre */
    clip_row(f->cosine, f->sine * dy, f->half_length + 0.5f, &low, &high);
    clip_row(-f->sine, f->cosine * dy, f->half_width + 0.5f, &low, &high);
    if (!(low <= high))
        return;
    int32_t from = (int32_t)floorf(f->centre_x + low - 0.5f);
    int32_t to = (int32_t)ceilf(f->centre_x + high - 0.5f);
    uint32_t row = wrap(y, size_px) * size_px, column = wrap(from, size_px);
    for (int32_t x = from; x <= to; x++, column = column + 1 == size_px ? 0 : column + 1) {
        float dx = (float)x + 0.5f - f->centre_x;
        float along = dx * f->cosine + dy * f->sine;
        float alpha = alpha_at(brush, f, along, dy * f->cosine - dx * f->sine);
        if (alpha > 0) {
            assert(out->count < out->capacity);
            out->at[out->count] = row + column;
            out->alpha[out->count] = alpha;
            float t = along * f->per_length + 0.5f;
            out->along[out->count++] = t < 0 ? 0 : t > 1 ? 1 : t;
        }
    }
}

/* A stroke that meets itself around the torus has pixels twice: one entry stays, the darkest. */
static void keep_darkest(struct hatch_footprint *out)
{
    uint32_t kept = 0;
    for (uint32_t i = 0; i < out->count; i++) {
        uint32_t *entry = &out->entry_of[out->at[i]];
        if (*entry == 0) {
            out->at[kept] = out->at[i];
            out->alpha[kept] = out->alpha[i];
            out->along[kept] = out->along[i];
            *entry = ++kept;
        } else if (out->alpha[*entry - 1] < out->alpha[i]) {
            out->alpha[*entry - 1] = out->alpha[i];
            out->along[*entry - 1] = out->along[i];
        }
    }
    out->count = kept;
    for (uint32_t i = 0; i < kept; i++)
        out->entry_of[out->at[i]] = 0;
}

void hatch_footprint_draw(const struct hatch_stroke *stroke, const struct hatch_brush *brush,
                          uint32_t size_px, float length_scale, float width_scale,
                          struct hatch_footprint *footprint)
{
    struct frame f = frame_of(stroke, brush, size_px, length_scale, width_scale);
    footprint->count = 0;
    if (!(f.half_width > 0))
        return;
    float reach_x = f.half_length * fabsf(f.cosine) + f.half_width * fabsf(f.sine) + 1;
    float reach_y = f.half_length * fabsf(f.sine) + f.half_width * fabsf(f.cosine) + 1;
    int32_t from = (int32_t)floorf(f.centre_y - reach_y), to = (int32_t)ceilf(f.centre_y + reach_y);
    for (int32_t y = from; y <= to; y++)
        draw_row(brush, &f, size_px, y, reach_x, footprint);
    if (2 * reach_x > (float)size_px || 2 * reach_y > (float)size_px)
        keep_darkest(footprint);
}

void hatch_footprint_remove(struct hatch_footprint *now, const struct hatch_footprint *before)
{
    for (uint32_t i = 0; i < before->count; i++)
        now->entry_of[before->at[i]] = i + 1;
    for (uint32_t i = 0; i < now->count; i++) {
        uint32_t entry = now->entry_of[now->at[i]];
        if (!entry)
            continue;
        float left = 1 - before->alpha[entry - 1];
        float added = left > 0 ? 1 - (1 - now->alpha[i]) / left : 0;
        now->alpha[i] = added > 0 ? added : 0;
    }
    for (uint32_t i = 0; i < before->count; i++)
        now->entry_of[before->at[i]] = 0;
}
