/* Strokes of a frame as curves: the GPU computes their widths, as for a picture, and the processor their places, in
 * doubles. */
#include <math.h>

#include "curve/width.h"
#include "render-gl/gpu/buffer.h"
#include "render-gl/technique/traced.h"

#define SLACK_GAPS                                                                                                     \
    0.5 /* of the finest gap: how far strokes may pass under the surface between their points, aslant                  \
         */

/* Curves under construction. */
struct gathering {
    struct hatch_arena *arena;
    struct hatch_buffer curves, points, faces, widths, slack;
    uint32_t count, layer_count;
};

/* Returns by how much a width exceeds the one that the law of curve/width.h gives where as many strokes are drawn as
 * are wanted: where the tone times the scale is the threshold times the width. */
static double drawn(const struct hatch_vector_pen *pen, double wanted_px)
{
    const struct hatch_stroke_pen alike = {.width_px = (float)pen->width_px, .thin = 1};
    return wanted_px - hatch_stroke_width_px(&alike, 1, 1 / pen->width_px, 1, HUGE_VAL);
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

/* Adds a stroke if any of it is drawn.
 *   ribbon  of its first point */
static enum hatch_status add_stroke(struct gathering *gathering, const struct hatch_scene_mesh *mesh,
                                    const struct traced_strokes *strokes, const struct traced_stroke *stroke,
                                    const double *positions, uint32_t first_face, float slack, const float *ribbon,
                                    struct hatch_err *err)
{
    const struct hatch_curve_point *points = &strokes->curve_points[stroke->curve->first];
    const struct hatch_vector_curve curve = {.first = (uint32_t)(gathering->slack.size / sizeof slack),
                                             .count = stroke->curve->count,
                                             .layer = stroke->family,
                                             .id = stroke->curve->id};
    bool any = false;
    for (uint32_t i = 0; i < curve.count; i++)
        any = any || ribbon[TRACED_RIBBON_FLOATS * i + 3] > 0;
    if (!any)
        return HATCH_OK;
    gathering->count++;
    gathering->layer_count = curve.layer + 1 > gathering->layer_count ? curve.layer + 1 : gathering->layer_count;
    HATCH_TRY(hatch_buffer_add(&gathering->curves, &curve, sizeof curve, err));
    for (uint32_t i = 0; i < curve.count; i++) {
        double at[3];
        const uint32_t face = first_face + points[i].face;
        const float width = fmaxf(2 * ribbon[TRACED_RIBBON_FLOATS * i + 3], 0);
        position_of(&mesh->mesh, positions, &points[i], at);
        HATCH_TRY(hatch_buffer_add(&gathering->points, at, sizeof at, err));
        HATCH_TRY(hatch_buffer_add(&gathering->faces, &face, sizeof face, err));
        HATCH_TRY(hatch_buffer_add(&gathering->widths, &width, sizeof width, err));
        HATCH_TRY(hatch_buffer_add(&gathering->slack, &slack, sizeof slack, err));
    }
    return HATCH_OK;
}

/* Adds the strokes of an item.
 *   first_face  number of its first face among those of all items */
static enum hatch_status add_item(struct gathering *gathering, struct technique_context *context,
                                  const struct traced_state *state, uint32_t index, uint32_t first_face,
                                  struct hatch_err *err)
{
    const struct hatch_unit_scene *unit = &context->frame->scene->unit;
    const struct hatch_item *item = &unit->items[index];
    const struct traced_strokes *strokes = traced_strokes_of(context->frame, state, index);
    uint32_t count = traced_place(context->frame, state, index, 0);
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

enum hatch_status traced_curves(struct technique_context *context, struct technique_instance *instance, double pen_px,
                                struct hatch_arena *arena, struct technique_curves *curves, struct hatch_err *err)
{
    const struct hatch_unit_scene *unit = &context->frame->scene->unit;
    struct traced_state *state = instance->state;
    struct gathering gathering = {.arena = arena,
                                  .curves = {.arena = arena},
                                  .points = {.arena = arena},
                                  .faces = {.arena = arena},
                                  .widths = {.arena = arena},
                                  .slack = {.arena = arena}};
    uint32_t first_face = 0;
    traced_set_style(context->frame, pen_px, state);
    HATCH_TRY(traced_refine(context, state, err));
    for (uint32_t i = 0; i < state->item_count; i++) {
        HATCH_TRY(add_item(&gathering, context, state, i, first_face, err));
        first_face += unit->meshes[unit->items[i].mesh].surface->face_count;
    }
    *curves = (struct technique_curves){.layer_count = gathering.layer_count,
                                        .curves = {.count = gathering.count,
                                                   .curves = (const void *)gathering.curves.data,
                                                   .points = (const void *)gathering.points.data,
                                                   .faces = (const void *)gathering.faces.data,
                                                   .widths_px = (const void *)gathering.widths.data,
                                                   .slack = (const void *)gathering.slack.data},
                                        .pen = {.width_px = pen_px, .drawn = drawn}};
    return HATCH_OK;
}
