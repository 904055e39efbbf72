/* Fitted strokes as paths for a pen, which draws a stroke where it is wide enough. */
#include <math.h>

#include "render-gl/gpu/bindings.h"
#include "render-gl/gpu/buffer.h"
#include "render-gl/technique/strokes/strokes.h"

#define SHORTEST_PX 2.0 /* shorter parts of strokes are left out */
#define DRAWN 0.5       /* mean width, in those of the texture's strokes, from which on the pen draws a stroke */

/* A point of a ribbon: place in pixels, and half the width; place along the whole stroke, and level of its zigzag. */
struct point {
    float x, y, depth, half_width, rest[5], t, level, unused;
};

/* Paths of a pen along the segments of ribbons. */
struct drawing {
    double half_px;   /* half the width from which on the stroke is drawn */
    double thin_px;   /* mean width from which on a stroke is drawn */
    double limits[2]; /* width and height of the picture */
    struct hatch_vector_builder paths;
    bool drawing;              /* a path has begun */
    const float *zigzag;       /* of struct traced_block */
    struct hatch_buffer turns; /* struct point: those of a stroke with its zigzag */
};

/* Returns the place along a stroke in waves of level 0. */
static double wave_of(const struct drawing *drawing, const struct point *point)
{
    return (double)point->t * (drawing->zigzag[2] > 0 ? (double)drawing->zigzag[2] : 1);
}

/* Finds the direction across a ribbon, to the left, at one of its points. */
static void find_across(const struct point *points, uint32_t k, double across[2])
{
    const struct point *before = &points[k > 0 ? k - 1 : 0], *after = &points[k + 1 < RIBBON_POINTS ? k + 1 : k];
    double x = (double)(after->x - before->x), y = (double)(after->y - before->y), length = fmax(hypot(x, y), 1e-12);
    across[0] = -y / length;
    across[1] = x / length;
}

/* Adds the point of a zigzag at a share of the way between two points of a ribbon. */
static enum hatch_status add_turn(struct drawing *drawing, const struct point *points, uint32_t k, double share,
                                  double wave, struct hatch_err *err)
{
    const struct point *a = &points[k], *b = &points[k + 1];
    struct point at = *a;
    double from[2], to[2], beside = (double)drawing->zigzag[0] * hatch_zigzag_beside(wave, (double)a->level);
    find_across(points, k, from);
    find_across(points, k + 1, to);
    at.x += (float)(share * (double)(b->x - a->x) + beside * (from[0] + share * (to[0] - from[0])));
    at.y += (float)(share * (double)(b->y - a->y) + beside * (from[1] + share * (to[1] - from[1])));
    at.half_width += (float)(share * (double)(b->half_width - a->half_width));
    return hatch_buffer_add(&drawing->turns, &at, sizeof at, err);
}

/* Finds the points between which a stroke is straight.
 *   points  RIBBON_POINTS of them; out: those of its zigzag if it has one
 *   count   out: their number */
static enum hatch_status follow_zigzag(struct drawing *drawing, const struct point **points, uint32_t *count,
                                       struct hatch_err *err)
{
    const struct point *ribbon = *points;
    *count = RIBBON_POINTS;
    if (!(drawing->zigzag[0] > 0))
        return HATCH_OK;
    drawing->turns.size = 0;
    for (uint32_t k = 0; k + 1 < RIBBON_POINTS; k++) {
        const double from = wave_of(drawing, &ribbon[k]), to = wave_of(drawing, &ribbon[k + 1]);
        double wave = from;
        do {
            HATCH_TRY(add_turn(drawing, ribbon, k, (wave - from) / fmax(to - from, 1e-12), wave, err));
            wave = hatch_zigzag_turn(wave, (double)ribbon->level);
        } while (wave < to);
    }
    HATCH_TRY(add_turn(drawing, ribbon, RIBBON_POINTS - 2, 1, wave_of(drawing, &ribbon[RIBBON_POINTS - 1]), err));
    *points = (const struct point *)(const void *)drawing->turns.data;
    *count = (uint32_t)(drawing->turns.size / sizeof **points);
    return HATCH_OK;
}

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

/* Adds the paths of all strokes.
 *   layer_counts  in: zeros; out: as in struct technique_curves */
static enum hatch_status add_strokes(struct drawing *drawing, const struct strokes_list *list,
                                     const struct point *points, uint32_t layer_counts[2], struct hatch_err *err)
{
    for (uint32_t i = 0; i < list->count; i++, points += RIBBON_POINTS) {
        uint32_t ink = list->strokes[i].id[0] & 1, layer = list->strokes[i].id[0] >> 1 & 63;
        if (layer >= HATCH_CURVE_FAMILIES_MAX)
            layer = HATCH_CURVE_FAMILIES_MAX - 1;
        const struct hatch_vector_path like = {.layer = ink * HATCH_CURVE_FAMILIES_MAX + layer,
                                               .id = list->strokes[i].id[0] >> STROKES_ID_HASH_SHIFT};
        const double mean = mean_half_width(points);
        const struct point *line = points;
        uint32_t count;
        if (list->lasts && !list->lasts[i])
            continue;
        layer_counts[ink] = layer >= layer_counts[ink] ? layer + 1 : layer_counts[ink];
        if (2 * mean < drawing->thin_px)
            continue;
        drawing->half_px = STROKES_THIN * mean;
        HATCH_TRY(follow_zigzag(drawing, &line, &count, err));
        for (uint32_t k = 0; k + 1 < count; k++)
            HATCH_TRY(add_segment(drawing, &like, &line[k], &line[k + 1], err));
        HATCH_TRY(end_path(drawing, err));
    }
    return HATCH_OK;
}

enum hatch_status strokes_curves(struct technique_context *context, struct technique_instance *instance, double pen_px,
                                 struct hatch_arena *arena, struct technique_curves *curves, struct hatch_err *err)
{
    const struct hatch_tile *tile = context->frame->request.tile;
    const struct strokes_state *state = instance->state;
    struct drawing drawing = {.limits = {tile->full_width, tile->full_height},
                              .paths = hatch_vector_builder_of(arena),
                              .zigzag = state->zigzag,
                              .turns = {.arena = arena}};
    struct strokes_list list;
    struct point *points;
    *curves = (struct technique_curves){.shortest_px = SHORTEST_PX, .look = &state->seeds.source.drawing.pen.look};
    HATCH_TRY(strokes_take(context, instance, pen_px, &list, err));
    drawing.thin_px = DRAWN * state->width_px;
    if (list.count) {
        HATCH_TRY(HATCH_ALLOC_UNSET(arena, &points, (size_t)RIBBON_POINTS * list.count, err));
        gpu_buffer_read(state->points.name, points, sizeof *points * RIBBON_POINTS * list.count);
        HATCH_TRY(add_strokes(&drawing, &list, points, curves->layer_counts, err));
    }
    curves->paths = hatch_vector_built(&drawing.paths);
    return HATCH_OK;
}
