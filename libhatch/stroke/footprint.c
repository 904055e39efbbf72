#include "stroke/footprint.h"

#include <assert.h>

#include "stroke/frame.h"
#include "stroke/path.h"

/* Returns an upper bound of the number of pixels of a stroke; pixels that it covers twice count twice. */
static double pixel_bound(double length, uint32_t size_px, double width_px)
{
    double reach = length * size_px + width_px + 4, across = width_px + 4;
    return reach * across * 2 + reach * 4 + 64;
}

enum hatch_status hatch_footprint_make(struct hatch_arena *arena, uint32_t size_px, float length, float width_px,
                                       struct hatch_footprint *footprint, struct hatch_err *err)
{
    struct hatch_footprint made = {0};
    double whole = pixel_bound((double)length, size_px, (double)width_px);
    /* Strokes longer than HATCH_LINE_LENGTH_MAX have paths, whose footprints never hold a pixel twice. */
    double straight = pixel_bound(fmin((double)length, HATCH_LINE_LENGTH_MAX), size_px, (double)width_px);
    double pixels = fmax(straight, fmin(whole, (double)size_px * size_px));
    if (!(whole < INFINITY) || !(pixels < UINT32_MAX / 2))
        return hatch_fail(err, HATCH_LIMIT, "a stroke of %g pixels is too large", pixels);
    made.capacity = (uint32_t)pixels;
    HATCH_TRY(HATCH_ALLOC(arena, &made.at, made.capacity, err));
    HATCH_TRY(HATCH_ALLOC(arena, &made.alpha, made.capacity, err));
    HATCH_TRY(HATCH_ALLOC(arena, &made.along, made.capacity, err));
    HATCH_TRY(HATCH_ALLOC(arena, &made.entry_of, (size_t)size_px * size_px, err));
    *footprint = made;
    return HATCH_OK;
}

static void add_pixel(const struct hatch_frame *f, const struct hatch_brush *brush, uint32_t at, float along,
                      float across, struct hatch_footprint *out)
{
    float alpha = hatch_frame_alpha(f, brush, along, across);
    if (!(alpha > 0))
        return;
    assert(out->count < out->capacity);
    out->at[out->count] = at;
    out->alpha[out->count] = alpha;
    float t = along * f->per_length + 0.5f;
    out->along[out->count++] = t < 0 ? 0 : t > 1 ? 1 : t;
}

/* Adds a pixel of an arc; its positions along and across the stroke are polar coordinates. The distance from the centre
 * of a long arc is not subtracted from its radius: both are large, and nearly equal.
 *   dx, dy  position relative to the middle of the arc, px */
static void add_arc_pixel(const struct hatch_frame *f, const struct hatch_brush *brush, uint32_t at, float dx, float dy,
                          struct hatch_footprint *out)
{
    double reach = fabs(f->radius), side = f->radius < 0 ? -1 : 1;
    double along = (double)(dx * f->cosine + dy * f->sine);
    double inward = (double)(dy * f->cosine - dx * f->sine) * side; /* from the middle towards the centre */
    double distance = sqrt(along * along + (reach - inward) * (reach - inward));
    double across = (2 * reach * inward - inward * inward - along * along) / (reach + distance);
    if (fabs(across) >= (double)f->half_width + 0.5)
        return;
    add_pixel(f, brush, at, (float)(reach * atan2(along, reach - inward)), (float)(across * side), out);
}

static void draw_row(const struct hatch_brush *brush, const struct hatch_frame *f, uint32_t size_px, int32_t y,
                     float reach_x, struct hatch_footprint *out)
{
    float dy = (float)y + 0.5f - f->centre_y;
    float low = -reach_x, high = reach_x; /* of dx */
    if (f->radius == 0) {
        hatch_frame_clip(f->cosine, f->sine * dy, f->half_length + 0.5f, &low, &high);
        hatch_frame_clip(-f->sine, f->cosine * dy, f->half_width + 0.5f, &low, &high);
    }
    if (!(low <= high))
        return;
    int32_t from = (int32_t)floorf(f->centre_x + low - 0.5f);
    int32_t to = (int32_t)ceilf(f->centre_x + high - 0.5f);
    uint32_t row = hatch_frame_wrap(y, size_px) * size_px, column = hatch_frame_wrap(from, size_px);
    for (int32_t x = from; x <= to; x++, column = column + 1 == size_px ? 0 : column + 1) {
        float dx = (float)x + 0.5f - f->centre_x;
        if (f->radius != 0)
            add_arc_pixel(f, brush, row + column, dx, dy, out);
        else
            add_pixel(f, brush, row + column, dx * f->cosine + dy * f->sine, dy * f->cosine - dx * f->sine, out);
    }
}

/* Merges the entries of each pixel into the darkest one. A stroke that overlaps itself around the torus has several for
 * one pixel. */
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

void hatch_footprint_draw(const struct hatch_stroke *stroke, const struct hatch_brush *brush, uint32_t size_px,
                          float length_scale, float width_scale, struct hatch_footprint *footprint)
{
    struct hatch_frame f = hatch_frame_make(stroke, brush, size_px, length_scale, width_scale);
    footprint->count = 0;
    if (!(f.half_width > 0))
        return;
    if (stroke->path) {
        hatch_footprint_draw_path(stroke, brush, &f, size_px, footprint);
        return;
    }
    float reach_x = f.half_length * fabsf(f.cosine) + f.half_width * fabsf(f.sine) + 1;
    float reach_y = f.half_length * fabsf(f.sine) + f.half_width * fabsf(f.cosine) + 1;
    if (f.radius != 0) /* no point of an arc is further than half the arc's length from its middle */
        reach_x = reach_y = f.half_length + f.half_width + 1;
    int32_t from = (int32_t)floorf(f.centre_y - reach_y), to = (int32_t)ceilf(f.centre_y + reach_y);
    for (int32_t y = from; y <= to; y++)
        draw_row(brush, &f, size_px, y, reach_x, footprint);
    if (2 * reach_x > (float)size_px || 2 * reach_y > (float)size_px)
        keep_darkest(footprint);
}

void hatch_footprint_subtract(struct hatch_footprint *now, const struct hatch_footprint *before)
{
    for (uint32_t i = 0; i < before->count; i++)
        now->entry_of[before->at[i]] = i + 1;
    for (uint32_t i = 0; i < now->count; i++) {
        uint32_t entry = now->entry_of[now->at[i]];
        if (!entry)
            continue;
        float transmittance = 1 - before->alpha[entry - 1];
        float added = transmittance > 0 ? 1 - (1 - now->alpha[i]) / transmittance : 0;
        now->alpha[i] = added > 0 ? added : 0;
    }
    for (uint32_t i = 0; i < before->count; i++)
        now->entry_of[before->at[i]] = 0;
}
