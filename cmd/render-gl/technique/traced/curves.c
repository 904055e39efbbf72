/* Strokes of a frame as curves: the GPU computes their widths, as for a picture, and the processor their places, in
 * doubles. */
#include <math.h>

#include "curve/marks.h"
#include "math/vector.h"
#include "render-gl/gpu/buffer.h"
#include "render-gl/technique/traced/traced.h"

#define SLACK_GAPS                                                                                                     \
    0.5 /* of the finest gap: how far strokes may pass under the surface between their points, aslant                  \
         */

#define SHORTEST_PX 2.0 /* shorter parts of strokes are left out */
#define PART 0.15       /* and those shorter than this share of a mark, unless marks are dots */
#define SLOPE 2.0       /* greatest slope of a surface on which marks are moved aside without passing under it */

/* A point of a stroke in the unit scene. */
struct place {
    double at[3];
    uint32_t face;
    float width, slack;
};

/* Curves under construction. */
struct gathering {
    struct hatch_arena *arena;
    const struct frame *frame;
    const struct hatch_stroke_pen *pen;
    struct hatch_buffer curves, points, faces, widths, slack;
    uint32_t count, ink, layer_counts[2]; /* ink: that of the strokes that are added */
};

/* Returns by how much a width exceeds the one that the law of curve/width.h gives where as many strokes are drawn as
 * are wanted: where the tone times the scale is the threshold times the width. */
static double drawn(const struct hatch_vector_pen *pen, double wanted_px)
{
    const struct hatch_stroke_pen alike = {.width_px = (float)pen->width_px, .thin = 1};
    return wanted_px - hatch_stroke_width_px(&alike, 1, 1 / pen->width_px, 1, HUGE_VAL, HUGE_VAL, 1);
}

/* Computes the position of a point in the unit scene.
 *   positions  of the vertices of the item's surface, in the unit scene */
static void position_of(const struct hatch_mesh *mesh, const double *positions, const struct hatch_curve_point *point,
                        double at[3])
{
    const uint32_t *corners = &mesh->indices[3 * (size_t)point->face];
    const double shares[3] = {1 - (double)point->share[0] - (double)point->share[1], (double)point->share[0],
                              (double)point->share[1]};
    for (int k = 0; k < 3; k++) {
        at[k] = 0;
        for (int c = 0; c < 3; c++)
            at[k] += shares[c] * positions[3 * (size_t)corners[c] + (size_t)k];
    }
}

static enum hatch_status add_place(struct gathering *gathering, const struct place *place, struct hatch_err *err)
{
    HATCH_TRY(hatch_buffer_add(&gathering->points, place->at, sizeof place->at, err));
    HATCH_TRY(hatch_buffer_add(&gathering->faces, &place->face, sizeof place->face, err));
    HATCH_TRY(hatch_buffer_add(&gathering->widths, &place->width, sizeof place->width, err));
    return hatch_buffer_add(&gathering->slack, &place->slack, sizeof place->slack, err);
}

/* Begins a curve of a stroke. */
static enum hatch_status add_curve(struct gathering *gathering, const struct traced_stroke *stroke, uint32_t count,
                                   struct hatch_err *err)
{
    const struct hatch_vector_curve curve = {.first = (uint32_t)(gathering->slack.size / sizeof(float)),
                                             .count = count,
                                             .layer = gathering->ink * HATCH_CURVE_FAMILIES_MAX + stroke->family,
                                             .id = stroke->curve->id};
    uint32_t *layers = &gathering->layer_counts[gathering->ink];
    gathering->count++;
    *layers = stroke->family >= *layers ? stroke->family + 1 : *layers;
    return hatch_buffer_add(&gathering->curves, &curve, sizeof curve, err);
}

/* Moves a place aside in the picture.
 *   ribbon     of the points before and after it
 *   beside_px  to the left of the way between them */
static void move(const struct gathering *gathering, const float *ribbon, double beside_px, struct place *place)
{
    const struct hatch_view *view = &gathering->frame->view;
    const float *next = ribbon + TRACED_RIBBON_FLOATS;
    double x = (double)(next[0] - ribbon[0]), y = (double)(next[1] - ribbon[1]), from[3];
    double length = fmax(sqrt(x * x + y * y), 1e-12);
    hatch_vec_sub(view->eye, place->at, from);
    double depth = view->orthographic ? 1 : hatch_vec_dot(from, view->back);
    double aside = beside_px * 2 * view->half_height * depth / gathering->frame->request.tile->full_height;
    hatch_vec_add_scaled(place->at, -y / length * aside, view->right, place->at);
    hatch_vec_add_scaled(place->at, x / length * aside, view->up, place->at);
    place->slack += (float)(SLOPE * fabs(aside));
}

/* Returns how far a zigzag lies beside the line at a place of a stroke, in pixels.
 *   next  in: place of the point after it; out: where the zigzag turns if it does so before */
static double zigzag_px(const struct hatch_stroke_pen *pen, double at, float scale, double *next)
{
    const double width_px = (double)pen->width_px, wave_px = (double)pen->look.zigzag_length * width_px;
    if (!(pen->look.zigzag > 0) || !(scale > 0))
        return 0;
    double level = log2((double)scale / wave_px);
    *next = fmin(*next, hatch_zigzag_turn(at, level));
    return (double)pen->look.zigzag * width_px * hatch_zigzag_beside(at, level);
}

/* Adds the place at an arc length of a stroke, between point `low` and the next one.
 *   beside_px  as for move */
static enum hatch_status add_place_at(struct gathering *gathering, const struct place *places, const float *ribbon,
                                      const struct hatch_mark_point *points, uint32_t low, double at, double beside_px,
                                      struct hatch_err *err)
{
    double share = (at - (double)points[low].at) / fmax((double)points[low + 1].at - (double)points[low].at, 1e-30);
    struct place place = places[low];
    for (int k = 0; k < 3; k++)
        place.at[k] += share * (places[low + 1].at[k] - place.at[k]);
    place.width += (float)share * (places[low + 1].width - place.width);
    move(gathering, ribbon + (size_t)TRACED_RIBBON_FLOATS * low, beside_px, &place);
    return add_place(gathering, &place, err);
}

/* Adds a mark of a stroke.
 *   places, ribbon, points  of the stroke, count of them */
static enum hatch_status add_mark(struct gathering *gathering, const struct traced_stroke *stroke,
                                  const struct place *places, const float *ribbon,
                                  const struct hatch_mark_point *points, const struct hatch_mark *mark,
                                  struct hatch_err *err)
{
    const double from = (double)mark->from, to = (double)mark->to, length = fmax(to - from, 1e-30);
    const uint32_t last = stroke->curve->count - 1;
    uint32_t low = 0, count = 0;
    double at = from;
    HATCH_TRY(add_curve(gathering, stroke, 0, err));
    size_t curve = gathering->curves.size / sizeof(struct hatch_vector_curve) - 1;
    for (bool ends = false; !ends; count++) {
        ends = at >= to;
        while (low + 1 < last && (ends ? (double)points[low + 1].at < at : (double)points[low + 1].at <= at))
            low++;
        double next = low + 1 < last ? fmin((double)points[low + 1].at, to) : to;
        double zigzag = zigzag_px(gathering->pen, at, points[low].scale, &next);
        double beside = (double)mark->beside[0] + (at - from) / length * (double)(mark->beside[1] - mark->beside[0]);
        HATCH_TRY(add_place_at(gathering, places, ribbon, points, low, at, beside + zigzag, err));
        at = next;
    }
    ((struct hatch_vector_curve *)(void *)gathering->curves.data)[curve].count = count;
    return HATCH_OK;
}

/* Adds the marks of a stroke, or the whole stroke if its pen has none. */
static enum hatch_status add_marks(struct gathering *gathering, const struct traced_stroke *stroke,
                                   const struct place *places, const float *ribbon, struct hatch_err *err)
{
    const uint32_t count = stroke->curve->count;
    struct hatch_buffer marks = {.arena = gathering->arena};
    struct hatch_mark_point *points;
    HATCH_TRY(HATCH_ALLOC_UNSET(gathering->arena, &points, count, err));
    for (uint32_t i = 0; i < count; i++) {
        const float *from = &ribbon[(size_t)TRACED_RIBBON_FLOATS * i];
        points[i] = (struct hatch_mark_point){from[6], from[8], from[9], from[10], from[11]};
        if (!(points[i].scale > 0) && i > 0) { /* out of sight */
            points[i].scale = points[i - 1].scale;
            points[i].level = points[i - 1].level;
        }
    }
    if (!(gathering->pen->mark_px > 0))
        return add_mark(gathering, stroke, places, ribbon, points,
                        &(struct hatch_mark){.from = points[0].at, .to = points[count - 1].at}, err);
    HATCH_TRY(hatch_marks_list(gathering->pen, stroke->curve->id & TRACED_HASH_BITS, points, count, &marks, err));
    for (size_t i = 0; i < marks.size / sizeof(struct hatch_mark); i++)
        HATCH_TRY(add_mark(gathering, stroke, places, ribbon, points,
                           (const struct hatch_mark *)(const void *)marks.data + i, err));
    return HATCH_OK;
}

/* Adds a stroke if any of it is drawn.
 *   ribbon  of its first point */
static enum hatch_status add_stroke(struct gathering *gathering, const struct hatch_scene_mesh *mesh,
                                    const struct traced_strokes *strokes, const struct traced_stroke *stroke,
                                    const double *positions, uint32_t first_face, float slack, const float *ribbon,
                                    struct hatch_err *err)
{
    const struct hatch_curve_point *points = &strokes->curve_points[stroke->curve->first];
    const uint32_t count = stroke->curve->count;
    struct place *places;
    bool any = false;
    for (uint32_t i = 0; i < count; i++)
        any = any || ribbon[TRACED_RIBBON_FLOATS * i + 3] > 0;
    if (!any)
        return HATCH_OK;
    HATCH_TRY(HATCH_ALLOC_UNSET(gathering->arena, &places, count, err));
    for (uint32_t i = 0; i < count; i++) {
        places[i] = (struct place){.face = first_face + points[i].face,
                                   .width = fmaxf(2 * ribbon[TRACED_RIBBON_FLOATS * i + 3], 0),
                                   .slack = slack};
        position_of(&mesh->mesh, positions, &points[i], places[i].at);
    }
    if (gathering->pen->mark_px > 0 || gathering->pen->look.zigzag > 0)
        return add_marks(gathering, stroke, places, ribbon, err);
    HATCH_TRY(add_curve(gathering, stroke, count, err));
    for (uint32_t i = 0; i < count; i++)
        HATCH_TRY(add_place(gathering, &places[i], err));
    return HATCH_OK;
}

/* Adds the strokes of an item in an ink.
 *   first_face  number of its first face among those of all items */
static enum hatch_status add_item(struct gathering *gathering, struct technique_context *context,
                                  struct traced_state *state, uint32_t index, uint32_t first_face,
                                  struct hatch_err *err)
{
    const struct hatch_unit_scene *unit = &context->frame->scene->unit;
    const struct hatch_item *item = &unit->items[index];
    const struct traced_strokes *strokes = traced_strokes_of(context->frame, state, index);
    uint32_t count = traced_place(context->frame, state, index, (int)gathering->ink, 0);
    if (count == 0)
        return HATCH_OK;
    double *positions, scale;
    float *ribbon;
    size_t floats = TRACED_RIBBON_FLOATS * (size_t)strokes->end[count - 1];
    HATCH_TRY(HATCH_ALLOC_UNSET(gathering->arena, &ribbon, floats, err));
    HATCH_TRY(HATCH_ALLOC_UNSET(gathering->arena, &positions,
                                3 * (size_t)unit->meshes[item->mesh].surface->vertex_count, err));
    gpu_buffer_read(traced_ribbon_of(state, index)->buffer, ribbon, sizeof *ribbon * floats);
    hatch_item_surface(unit, item, positions, NULL);
    scale = traced_scale(context->frame->scene, item);
    for (uint32_t i = 0; i < count; i++)
        HATCH_TRY(add_stroke(gathering, &unit->scene->meshes[item->mesh], strokes, &strokes->sources[i], positions,
                             first_face, (float)(SLACK_GAPS * (double)strokes->finest * scale),
                             &ribbon[TRACED_RIBBON_FLOATS * (size_t)(i > 0 ? strokes->end[i - 1] : 0)], err));
    return HATCH_OK;
}

static double shortest_px(const struct hatch_stroke_pen *pen)
{
    return hatch_pen_has_dots(pen) ? 0 : fmax(SHORTEST_PX, PART * (double)pen->mark_px);
}

enum hatch_status traced_curves(struct technique_context *context, struct technique_instance *instance, double pen_px,
                                struct hatch_arena *arena, struct technique_curves *curves, struct hatch_err *err)
{
    const struct hatch_unit_scene *unit = &context->frame->scene->unit;
    struct traced_state *state = instance->state;
    struct gathering gathering = {.arena = arena,
                                  .frame = context->frame,
                                  .pen = &state->pen,
                                  .curves = {.arena = arena},
                                  .points = {.arena = arena},
                                  .faces = {.arena = arena},
                                  .widths = {.arena = arena},
                                  .slack = {.arena = arena}};
    uint32_t first_face = 0;
    traced_set_style(context->frame, pen_px, state);
    HATCH_TRY(traced_refine(context, state, err));
    for (uint32_t i = 0; i < state->item_count; i++) {
        for (gathering.ink = 0; gathering.ink < (context->frame->style.inks.two ? 2 : 1); gathering.ink++)
            HATCH_TRY(add_item(&gathering, context, state, i, first_face, err));
        first_face += unit->meshes[unit->items[i].mesh].surface->face_count;
    }
    *curves = (struct technique_curves){.layer_counts = {gathering.layer_counts[0], gathering.layer_counts[1]},
                                        .shortest_px = shortest_px(&state->pen),
                                        .curves = {.count = gathering.count,
                                                   .curves = (const void *)gathering.curves.data,
                                                   .points = (const void *)gathering.points.data,
                                                   .faces = (const void *)gathering.faces.data,
                                                   .widths_px = (const void *)gathering.widths.data,
                                                   .slack = (const void *)gathering.slack.data},
                                        .pen = {.width_px = pen_px, .drawn = drawn},
                                        .look = &state->pen.look};
    return HATCH_OK;
}
