/* Strokes finer than those of the file, for views from near (trace/finer.h). */
#include <math.h>
#include <string.h>

#include "curve/marks.h"
#include "math/vector.h"
#include "render-gl/gpu/buffer.h"
#include "render-gl/technique/traced/traced.h"

#define KEEP_BYTES ((size_t)64 << 20) /* of strokes that no view needs at present, per mesh */
#define MARGIN_PX 16.0                /* around the picture */
#define NEAREST 1e-9                  /* distance to an item's box, in radii of the scene, that counts as none */

/* Computes how many strokes per pixel the pen draws on a mesh, those that fade in included.
 *   strokes  of the mesh's file
 *   most     out: per family, at ink 0, 1/32 .. 1
 * Returns the largest number. */
static double find_most(struct traced_state *state, const struct traced_strokes *strokes,
                        float most[HATCH_CURVE_FAMILIES_MAX][HATCH_STROKE_TONES])
{
    const double fading = HATCH_STROKE_FADE / HATCH_STROKE_GAIN;
    double largest = 0;
    traced_set_families(strokes->families, state);
    memset(most, 0, sizeof *most * HATCH_CURVE_FAMILIES_MAX);
    for (uint32_t f = 0; f < strokes->families; f++)
        for (uint32_t i = 0; i < HATCH_STROKE_TONES; i++) {
            float own = state->block.tones[f][i], across = strokes->narrow ? state->block.narrow[0][i] : 0;
            double tone = hatch_mark_stroke_tone(&state->pen, (double)fmaxf(own, across));
            double whole_px = hatch_stroke_whole_px(&state->pen, tone);
            most[f][i] = (float)(state->alike ? tone / whole_px : fading * tone / whole_px);
            largest = fmax(largest, (double)most[f][i]);
        }
    return largest;
}

/* Returns the least distance of an item's box along the axis of the view; of an orthographic view, 1. */
static double nearest_depth(const struct hatch_view *view, const struct hatch_item *item)
{
    double nearest = HUGE_VAL;
    for (int corner = 0; corner < 8; corner++) {
        double depth = 0;
        for (int k = 0; k < 3; k++)
            depth -= view->back[k] * ((corner >> k & 1 ? item->high[k] : item->low[k]) - view->eye[k]);
        nearest = fmin(nearest, depth);
    }
    return view->orthographic ? 1 : fmax(nearest, NEAREST);
}

/* Returns whether the strokes of the file may be too few somewhere on an item.
 *   alike  all strokes are as wide as the pen */
static bool is_near(const struct frame *frame, const struct hatch_item *item, const struct traced_strokes *strokes,
                    double most, bool alike)
{
    const double start = alike ? HATCH_FINER_ALIKE * (double)strokes->fewest
                               : HATCH_STROKE_FADE * HATCH_FINER_START * (double)strokes->densest;
    const struct hatch_view *view = &frame->view;
    double scale = traced_scale(frame->scene, item) * frame->request.tile->full_height / (2 * view->half_height);
    return most * scale > start * nearest_depth(view, item);
}

/* Describes how the whole picture shows an item. */
static void describe(const struct frame *frame, const struct hatch_item *item, struct hatch_finer_view *shown)
{
    const struct hatch_view *view = &frame->view;
    const double *axes[3] = {view->right, view->up, view->back};
    const double *origin = frame->scene->unit.meshes[item->mesh].origin;
    double height = view->half_height, size[3] = {1 / (height * view->aspect), 1 / height, -1};
    *shown = (struct hatch_finer_view){.width_px = frame->request.tile->full_width,
                                       .height_px = frame->request.tile->full_height,
                                       .margin_px = MARGIN_PX,
                                       .front = !item->mirrored || item->double_sided,
                                       .behind = item->mirrored || item->double_sided};
    for (int row = 0; row < 3; row++) {
        double *m = &shown->clip_from_mesh[row < 2 || view->orthographic ? row : 3], offset = 0;
        double sign = row == 2 && view->orthographic ? -1 : 1; /* an orthographic z is the nearness itself */
        for (int k = 0; k < 3; k++)
            offset += axes[row][k] * ((double)item->to_unit[12 + k] - view->eye[k] - view->eye_low[k]);
        for (int c = 0; c < 3; c++) {
            for (int k = 0; k < 3; k++)
                m[4 * c] += sign * size[row] * axes[row][k] * (double)item->to_unit[4 * c + k];
            offset -= m[4 * c] / (sign * size[row]) * origin[c];
        }
        m[12] = sign * size[row] * offset;
    }
    shown->clip_from_mesh[view->orthographic ? 15 : 14] = 1;
}

/* Makes the finer strokes of a mesh ready to be traced. */
static enum hatch_status open_finer(struct technique_context *context, struct traced_state *state, uint32_t mesh,
                                    struct hatch_err *err)
{
    const struct hatch_scene_mesh *from = &context->frame->scene->unit.scene->meshes[mesh];
    struct cmd_args *args = context->args;
    const struct hatch_finer_source source = {.mesh = &from->mesh,
                                              .curves = &from->curves,
                                              .thresholds = state->strokes[mesh].thresholds,
                                              .pool = cmd_pool(args),
                                              .limit_bytes = args->max_memory,
                                              .keep_bytes = KEEP_BYTES};
    return hatch_finer_make(&source, &state->finer[mesh], err);
}

/* Reads the ink at the vertices of an item, if it is computed there.
 *   ink  out: 2 per vertex; NULL: computed per pixel, or with a texture */
static enum hatch_status read_ink(const struct frame *frame, const struct traced_state *state, uint32_t index,
                                  struct hatch_arena *arena, float **ink, struct hatch_err *err)
{
    const struct hatch_unit_scene *unit = &frame->scene->unit;
    const struct hatch_item *item = &unit->items[index];
    uint32_t count = unit->meshes[item->mesh].mesh->vertex_count;
    float *placed;
    *ink = NULL;
    if (frame->style.pixel_light || frame->style.shadows ||
        (frame->style.base_tone && frame->scene->items[index].base_texture))
        return HATCH_OK;
    traced_place_vertices(frame, state, index);
    HATCH_TRY(HATCH_ALLOC_UNSET(arena, ink, 2 * (size_t)count, err));
    HATCH_TRY(HATCH_ALLOC_UNSET(arena, &placed, 8 * (size_t)count, err));
    gpu_buffer_read(state->items[index].placed, placed, sizeof *placed * 8 * count);
    for (size_t v = 0; v < count; v++) {
        const float *amounts = &placed[8 * v + 4]; /* of both inks, on the front and behind */
        for (size_t k = 0; k < 2; k++)
            (*ink)[2 * v + (item->mirrored ? 1 - k : k)] = fmaxf(amounts[2 * k], amounts[2 * k + 1]);
    }
    return HATCH_OK;
}

/* Returns whether two views of an item are the same. */
static bool is_same(const struct hatch_finer_view *a, const struct hatch_finer_view *b, uint32_t vertex_count)
{
    if (memcmp(a->clip_from_mesh, b->clip_from_mesh, sizeof a->clip_from_mesh) != 0 ||
        memcmp(a->most, b->most, sizeof *a->most * HATCH_CURVE_FAMILIES_MAX) != 0 || !a->ink != !b->ink)
        return false;
    const double sizes[2][6] = {{a->width_px, a->height_px, a->densest, a->front, a->behind, a->alike},
                                {b->width_px, b->height_px, b->densest, b->front, b->behind, b->alike}};
    return memcmp(sizes[0], sizes[1], sizeof sizes[0]) == 0 && a->levels == b->levels &&
           (!a->ink || memcmp(a->ink, b->ink, sizeof *a->ink * 2 * vertex_count) == 0);
}

/* Finds the strokes of a near item and uploads them.
 *   view  without ink */
static enum hatch_status update(struct technique_context *context, struct traced_state *state, uint32_t index,
                                struct hatch_finer_view *view, struct hatch_err *err)
{
    const struct hatch_unit_scene *unit = &context->frame->scene->unit;
    const struct hatch_item *item = &unit->items[index];
    const struct hatch_mesh *mesh = &unit->scene->meshes[item->mesh].mesh;
    struct traced_item *own = &state->items[index];
    struct hatch_arena arena;
    float *ink;
    hatch_arena_init(&arena, context->args->max_memory);
    enum hatch_status status = read_ink(context->frame, state, index, &arena, &ink, err);
    view->ink = ink;
    if (status != HATCH_OK || (own->seen && is_same(&own->view, view, mesh->vertex_count))) {
        hatch_arena_free(&arena);
        return status;
    }
    traced_forget(own);
    own->arena = arena;
    own->seen = true;
    own->view = *view;
    HATCH_TRY(HATCH_ALLOC(&own->arena, &own->view.most, HATCH_CURVE_FAMILIES_MAX, err));
    memcpy(own->view.most, view->most, sizeof *view->most * HATCH_CURVE_FAMILIES_MAX);
    if (!state->finer[item->mesh])
        HATCH_TRY(open_finer(context, state, item->mesh, err));
    HATCH_TRY(hatch_finer_find(state->finer[item->mesh], &own->view, &own->arena, &own->found, err));
    if (own->found.curves.count == 0)
        return HATCH_OK;
    const struct traced_source source = {.mesh = mesh, .curves = &own->found.curves, .parts = own->found.parts};
    HATCH_TRY(traced_upload(&source, &own->arena, &context->args->scratch, &own->strokes, err));
    own->strokes.densest =
        own->found.enough ? (float)own->found.densest : fminf(own->strokes.densest, (float)own->found.densest);
    if (own->found.enough)
        own->strokes.raised = (float)own->found.raised;
    own->strokes.finest = fminf(own->strokes.finest, state->strokes[item->mesh].finest);
    return traced_make_ribbon(&own->strokes, &own->near, err);
}

void traced_forget(struct traced_item *item)
{
    if (!item->seen)
        return;
    traced_free_strokes(&item->strokes);
    traced_free_ribbon(&item->near);
    hatch_arena_free(&item->arena);
    item->strokes = (struct traced_strokes){.count = 0};
    item->near = (struct traced_ribbon){0, 0};
    item->seen = false;
}

enum hatch_status traced_refine(struct technique_context *context, struct traced_state *state, struct hatch_err *err)
{
    const struct frame *frame = context->frame;
    for (uint32_t i = 0; i < state->item_count; i++) {
        const struct hatch_item *item = &frame->scene->unit.items[i];
        const struct traced_strokes *strokes = &state->strokes[item->mesh];
        struct hatch_finer_view view;
        if (state->finer_levels == 0 || strokes->count == 0 || item->deformed ||
            !is_near(frame, item, strokes, find_most(state, strokes, state->most), state->alike)) {
            traced_forget(&state->items[i]);
            continue;
        }
        describe(frame, item, &view);
        view.most = state->most;
        view.levels = state->finer_levels;
        view.densest = (double)(state->alike ? strokes->fewest : strokes->densest);
        view.alike = state->alike;
        HATCH_TRY(update(context, state, i, &view, err));
    }
    return HATCH_OK;
}
