#include "placement/canvas.h"

#include <string.h>

enum hatch_status hatch_canvas_make(const struct hatch_canvas_options *options, struct hatch_arena *arena,
                                    struct hatch_canvas *canvas, struct hatch_err *err)
{
    const struct hatch_style *style = options->style;
    uint32_t size_px = options->size_px;
    struct hatch_canvas made = {.style = style, .brush = options->brush, .size_px = size_px, .levels = options->levels};
    for (uint32_t level = 0; level < options->levels; level++) {
        size_t pixels = (size_t)(size_px >> level) * (size_px >> level);
        HATCH_TRY(HATCH_ALLOC(arena, &made.paper[level], pixels, err));
        for (size_t i = 0; i < pixels; i++)
            made.paper[level][i] = 1;
        if (options->color && !(made.rgb[level] = HATCH_NEW(arena, float, 3 * pixels, err)))
            return HATCH_LIMIT;
        for (size_t i = 0; options->color && i < 3 * pixels; i++)
            made.rgb[level][i] = 1;
        if (!options->ids)
            continue;
        HATCH_TRY(HATCH_ALLOC(arena, &made.id[level], pixels, err));
        HATCH_TRY(HATCH_ALLOC(arena, &made.along[level], pixels, err));
    }
    HATCH_TRY(hatch_footprint_make(arena, size_px, style->length_max, style->width_px, &made.footprint, err));
    HATCH_TRY(hatch_footprint_make(arena, size_px, style->length_max, style->width_px, &made.before, err));
    HATCH_TRY(HATCH_ALLOC(arena, &made.change, made.footprint.capacity, err));
    *canvas = made;
    return HATCH_OK;
}

/* Returns the reflectance of one channel after a stroke. It is never larger than before, so that columns nest pixel by
 * pixel. */
static float inked(enum hatch_overlap overlap, float paper, float alpha, float color)
{
    float alone = 1 - alpha * (1 - color);
    if (overlap == HATCH_OVERLAP_DARKENS)
        return paper * alone;
    float covered = overlap == HATCH_OVERLAP_FLAT ? alone : paper * (1 - alpha) + alpha * color;
    return paper < covered ? paper : covered;
}

/* Returns the reflectance of the i-th pixel of the footprint after the stroke; in colour the mean of rgb.
 *   rgb  out: only in colour */
static float inked_pixel(const struct hatch_canvas *canvas, const struct hatch_stroke *stroke, uint32_t level,
                         uint32_t i, float rgb[3])
{
    size_t at = canvas->footprint.at[i];
    float alpha = canvas->footprint.alpha[i];
    if (!canvas->rgb[level])
        return inked(canvas->style->overlap, canvas->paper[level][at], alpha,
                     (stroke->rgb[0] + stroke->rgb[1] + stroke->rgb[2]) / 3);
    for (uint32_t c = 0; c < 3; c++)
        rgb[c] = inked(canvas->style->overlap, canvas->rgb[level][3 * at + c], alpha, stroke->rgb[c]);
    return (rgb[0] + rgb[1] + rgb[2]) / 3;
}

static double measure_change(struct hatch_canvas *canvas, const struct hatch_stroke *stroke, uint32_t level)
{
    const struct hatch_footprint *f = &canvas->footprint;
    const float *paper = canvas->paper[level];
    double sum = 0;
    for (uint32_t i = 0; i < f->count; i++) {
        float rgb[3];
        canvas->change[i] = paper[f->at[i]] - inked_pixel(canvas, stroke, level, i, rgb);
        sum += (double)canvas->change[i];
    }
    double size = hatch_canvas_size(canvas, level);
    return sum / (size * size);
}

/* Returns the width scale of a growing stroke. It widens half as fast as it lengthens, because a stroke that starts
 * very thin would be grey. */
static float width_scale(float scale)
{
    return (1 + scale) * 0.5f;
}

double hatch_canvas_try(struct hatch_canvas *canvas, const struct hatch_stroke *stroke, uint32_t level, float scale)
{
    hatch_footprint_draw(stroke, canvas->brush, hatch_canvas_size(canvas, level), scale, width_scale(scale),
                         &canvas->footprint);
    return measure_change(canvas, stroke, level);
}

/* Gives a stroke's pixels to it that no other has.
 *   scale  of its length: places along it are those along the whole stroke, of which the middle is drawn first */
static void mark_ids(struct hatch_canvas *canvas, uint32_t level, uint32_t id, float scale)
{
    const struct hatch_footprint *f = &canvas->footprint;
    for (uint32_t i = 0; i < f->count; i++) {
        float *owner = &canvas->id[level][f->at[i]];
        if (*owner > 0)
            continue;
        *owner = (float)id;
        canvas->along[level][f->at[i]] = 0.5f + (f->along[i] - 0.5f) * scale;
    }
}

void hatch_canvas_draw(struct hatch_canvas *canvas, const struct hatch_stroke *stroke, uint32_t level,
                       float scale_before, float scale)
{
    uint32_t size_px = hatch_canvas_size(canvas, level);
    struct hatch_footprint *f = &canvas->footprint;
    hatch_footprint_draw(stroke, canvas->brush, size_px, scale, width_scale(scale), f);
    if (scale_before > 0 && canvas->style->overlap != HATCH_OVERLAP_FLAT) {
        hatch_footprint_draw(stroke, canvas->brush, size_px, scale_before, width_scale(scale_before), &canvas->before);
        hatch_footprint_subtract(f, &canvas->before);
    }
    canvas->darkness[level] += measure_change(canvas, stroke, level);
    for (uint32_t i = 0; i < f->count; i++) {
        float rgb[3];
        canvas->paper[level][f->at[i]] = inked_pixel(canvas, stroke, level, i, rgb);
        if (canvas->rgb[level])
            memcpy(canvas->rgb[level] + 3 * (size_t)f->at[i], rgb, sizeof rgb);
    }
    if (canvas->id[level])
        mark_ids(canvas, level, stroke->id, scale);
}
