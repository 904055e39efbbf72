/* Fitted strokes as paths for a pen, which draws a stroke where it is wide enough. */
#include <math.h>

#include "render-gl/gpu/bindings.h"
#include "render-gl/gpu/buffer.h"
#include "render-gl/technique/strokes/strokes.h"

#define SHORTEST_PX 2.0 /* shorter parts of strokes are left out */
#define DRAWN 0.5       /* mean width, in those of the texture's strokes, from which on the pen draws a stroke */

/* A point of a ribbon: places in pixels, and half the width. */
struct point {
    float x, y, depth, half_width, rest[8];
};

/* Paths of a pen along the segments of ribbons. */
struct drawing {
    double half_px;   /* half the width from which on the stroke is drawn */
    double thin_px;   /* mean width from which on a stroke is drawn */
    double limits[2]; /* width and height of the picture */
    struct hatch_vector_builder paths;
    bool drawing; /* a path has begun */
};

/* Narrows the range of a segment to that in which a quantity, linear along it, is not negative. */
static void narrow(double from, double to, double range[2])
{
    if (from < 0 && to < 0)
        range[1] = -1;
    else if (from < 0)
        range[0] = fmax(range[0], from / (from - to));
    else if (to < 0)
        range[1] = fmin(range[1], from / (from - to));
}

static enum hatch_status end_path(struct drawing *drawing, struct hatch_err *err)
{
    bool began = drawing->drawing;
    drawing->drawing = false;
    return began ? hatch_vector_end(&drawing->paths, false, err) : HATCH_OK;
}

/* Adds what the pen draws of a segment to the path that has begun, or to a new one. */
static enum hatch_status add_segment(struct drawing *drawing, const struct hatch_vector_path *like,
                                     const struct point *a, const struct point *b, struct hatch_err *err)
{
    const double from[2] = {(double)a->x, (double)a->y}, to[2] = {(double)b->x, (double)b->y};
    double range[2] = {0, 1};
    narrow((double)a->half_width - drawing->half_px, (double)b->half_width - drawing->half_px, range);
    for (int k = 0; k < 2; k++) {
        narrow(from[k], to[k], range);
        narrow(drawing->limits[k] - from[k], drawing->limits[k] - to[k], range);
    }
    if (range[0] >= range[1])
        return end_path(drawing, err);
    if (range[0] > 0)
        HATCH_TRY(end_path(drawing, err));
    for (int end = drawing->drawing ? 1 : 0; end < 2; end++) {
        const double at[2] = {from[0] + range[end] * (to[0] - from[0]), from[1] + range[end] * (to[1] - from[1])};
        if (!drawing->drawing)
            hatch_vector_begin(&drawing->paths, like);
        drawing->drawing = true;
        HATCH_TRY(hatch_vector_add(&drawing->paths, at, err));
    }
    return range[1] < 1 ? end_path(drawing, err) : HATCH_OK;
}

/* Returns half the mean width of a stroke. */
static double mean_half_width(const struct point *points)
{
    double area = 0, length = 0;
    for (uint32_t k = 0; k + 1 < RIBBON_POINTS; k++) {
        double step = hypot((double)(points[k + 1].x - points[k].x), (double)(points[k + 1].y - points[k].y));
        area += step * (double)(points[k].half_width + points[k + 1].half_width) / 2;
        length += step;
    }
    return area / fmax(length, 1e-12);
}

/* Adds the paths of all strokes of the first ink.
 *   layer_count  out */
static enum hatch_status add_strokes(struct drawing *drawing, const struct strokes_list *list,
                                     const struct point *points, uint32_t *layer_count, struct hatch_err *err)
{
    *layer_count = 0;
    for (uint32_t i = 0; i < list->count; i++, points += RIBBON_POINTS) {
        uint32_t layer = list->strokes[i].id[0] >> 1 & 63;
        if (layer >= HATCH_CURVE_FAMILIES_MAX)
            layer = HATCH_CURVE_FAMILIES_MAX - 1;
        const struct hatch_vector_path like = {.layer = layer, .id = list->strokes[i].id[1]};
        const double mean = mean_half_width(points);
        if (list->strokes[i].id[0] & 1)
            continue;
        *layer_count = layer >= *layer_count ? layer + 1 : *layer_count;
        if (2 * mean < drawing->thin_px)
            continue;
        drawing->half_px = STROKES_THIN * mean;
        for (uint32_t k = 0; k + 1 < RIBBON_POINTS; k++)
            HATCH_TRY(add_segment(drawing, &like, &points[k], &points[k + 1], err));
        HATCH_TRY(end_path(drawing, err));
    }
    return HATCH_OK;
}

enum hatch_status strokes_curves(struct technique_context *context, struct technique_instance *instance, double pen_px,
                                 struct hatch_arena *arena, struct technique_curves *curves, struct hatch_err *err)
{
    const struct hatch_tile *tile = context->frame->request.tile;
    const struct strokes_state *state = instance->state;
    struct drawing drawing = {.limits = {tile->full_width, tile->full_height}, .paths = hatch_vector_builder_of(arena)};
    struct strokes_list list;
    struct point *points;
    *curves = (struct technique_curves){.shortest_px = SHORTEST_PX};
    HATCH_TRY(strokes_find(context, instance, pen_px, &list, err));
    drawing.thin_px = DRAWN * state->width_px;
    if (list.count) {
        HATCH_TRY(HATCH_ALLOC_UNSET(arena, &points, (size_t)RIBBON_POINTS * list.count, err));
        gpu_buffer_read(state->points.name, points, sizeof *points * RIBBON_POINTS * list.count);
        HATCH_TRY(add_strokes(&drawing, &list, points, &curves->layer_count, err));
    }
    curves->paths = hatch_vector_built(&drawing.paths);
    return HATCH_OK;
}
