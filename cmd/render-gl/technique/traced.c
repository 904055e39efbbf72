#include "render-gl/technique/traced/traced.h"

#include <float.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "curve/marks.h"
#include "math/vector.h"
#include "placement/style.h"
#include "render-gl/frame/parts.h"
#include "render-gl/gpu/bindings.h"
#include "render-gl/gpu/buffer.h"
#include "render-gl/gpu/texture.h"
#include "render-gl/technique/list.h"
#include "shared/style.h"

#define CHORD 0.3      /* share of the finest gap by which strokes may pass under the surface between their points */
#define NARROWEST 0.02 /* share of the view's distance at which an item's strokes are all taken as visible */
#define SMOOTH 8.0     /* greatest threshold in sight, in finest gaps, from which on lines are drawn as curves */
#define DEPTHS_PX 32u  /* beyond a tile, in which surfaces are drawn, too: about the longest line between two points */
#define PARTS_MAX 4u   /* straight parts of a line between two points in near views */
#define LINE_PRESSURE 0.3f /* share of the strokes' changes of ink that feature lines have: they must hold together */
#define MOST_INK 0.95f     /* that strokes of one direction make */
#define NARROW_JOIN 0.7f   /* ink from which on other families join the one that crosses a narrow face */
#define OFF_AXIS 1.5       /* factor of scale towards the corners of a picture */

static const char *style_name = "engraving";
static double width_px; /* 0: the style's */
static int64_t finer_levels = HATCH_FINER_LEVELS_MAX;

static const struct cmd_option options[] = {
    {0, "stroke-style", CMD_TEXT, 0, 0, "STYLE",
     "+traced: drawing style of the strokes, a name or a file (default engraving)", &style_name, NULL, NULL},
    {0, "stroke-width", CMD_REAL, 0.2, 64, "PX", "+traced: width of strokes in pixels (default: the style's)",
     &width_px, NULL, NULL},
    {0, "finer", CMD_INT, 0, HATCH_FINER_LEVELS_MAX, "LEVELS",
     "+traced: levels that near views may add to those of the file (default 24)", &finer_levels, NULL, NULL},
    {0},
};
static const struct technique_param params[] = {{"stroke-width", true, 1.1}, {0}};

/* Returns a pen that draws all strokes alike, whose strokes do not overlap, but dots do. */
static struct hatch_stroke_pen even_pen(const struct hatch_stroke_pen *style)
{
    struct hatch_stroke_pen pen = {.thin = 1,
                                   .join = style->join,
                                   .mark_px = style->mark_px,
                                   .gap_px = style->gap_px,
                                   .scatter = style->scatter,
                                   .look = style->look,
                                   .taper_px = hatch_pen_has_dots(style) ? style->taper_px : 0,
                                   .response = {0.125f, 0.25f, 0.375f, 0.5f, 0.625f, 0.75f, 0.85f, 0.9f}};
    for (uint32_t i = 0; i < HATCH_STROKE_RESPONSES; i++)
        if (hatch_pen_has_dots(style))
            pen.response[i] = style->response[i];
        else if (style->mark_px > 0 && style->gap_px > 0)
            pen.response[i] *= style->mark_px / (style->mark_px + style->gap_px);
    for (uint32_t i = 0; i < HATCH_STROKE_RESPONSES; i++)
        pen.response[i] = fminf((float)hatch_zigzag_stretch(&style->look) * pen.response[i], MOST_INK);
    return pen;
}

static void read_style(struct technique_context *context, struct technique_instance *instance)
{
    struct traced_state *state = instance->state;
    struct hatch_brush brush;
    cmd_read_style(context->args, style_name, NULL, NULL, &state->style, &brush);
    state->finer_levels = (uint32_t)finer_levels;
    state->style.pen.width_px = state->style.width_px;
    if (!(width_px > 0))
        width_px = (double)state->style.width_px;
}

static enum hatch_status check(const struct hatch_scene *scene, const struct hatch_patch_mesh *patches,
                               struct hatch_err *err)
{
    (void)patches;
    for (uint32_t i = 0; i < scene->mesh_count; i++)
        if (scene->meshes[i].curves.count > 0)
            return HATCH_OK;
    return hatch_fail(err, HATCH_BAD_INPUT, "there are no strokes on the meshes: make them with strokegen");
}

static enum hatch_status upload(struct technique_context *context, struct traced_state *state, struct hatch_err *err)
{
    const struct scene *scene = context->frame->scene;
    const struct hatch_scene *from = scene->unit.scene;
    struct hatch_arena *keep = &context->args->keep;
    HATCH_TRY(HATCH_ALLOC(keep, &state->strokes, from->mesh_count, err));
    HATCH_TRY(HATCH_ALLOC(keep, &state->finer, from->mesh_count, err));
    HATCH_TRY(HATCH_ALLOC(keep, &state->items, scene->unit.item_count, err));
    state->mesh_count = from->mesh_count;
    state->item_count = scene->unit.item_count;
    glCreateVertexArrays(1, &state->array);
    for (uint32_t i = 0; i < from->mesh_count; i++)
        if (from->meshes[i].curves.count > 0 && from->meshes[i].mesh.face_count > 0) {
            const struct traced_source source = {
                .mesh = &from->meshes[i].mesh, .curves = &from->meshes[i].curves, .pool = cmd_pool(context->args)};
            HATCH_TRY(traced_upload(&source, keep, &context->args->scratch, &state->strokes[i], err));
        }
    for (uint32_t i = 0; i < scene->unit.item_count; i++) {
        uint32_t mesh = scene->unit.items[i].mesh;
        const struct traced_strokes *strokes = &state->strokes[mesh];
        struct traced_item *item = &state->items[i];
        if (strokes->count == 0)
            continue;
        item->placed = gpu_buffer_make(NULL, 8 * sizeof(float) * from->meshes[mesh].mesh.vertex_count);
        HATCH_TRY(traced_make_ribbon(strokes, &item->ribbon, err));
    }
    return gpu_check_memory(err, "strokes");
}

static enum hatch_status prepare(struct technique_context *context, struct technique_instance *instance,
                                 struct hatch_err *err)
{
    static const struct gpu_stages vertices = {.compute = "traced/vertices.comp"};
    static const struct gpu_stages points = {.compute = "traced/points.comp"};
    static const struct gpu_stages ribbon = {.vertex = "traced/ribbon.vert", .fragment = "traced/ribbon.frag"};
    static const struct gpu_stages curve = {.vertex = "traced/curve.vert", .fragment = "traced/ribbon.frag"};
    struct gpu_programs *programs = &context->frame->programs;
    struct traced_state *state = instance->state;
    char light[FRAME_LIGHT_DEFINES_BYTES], based[FRAME_LIGHT_DEFINES_BYTES + 32];
    if (!state->strokes)
        HATCH_TRY(upload(context, state, err));
    frame_light_defines(context->frame, true, light);
    snprintf(based, sizeof based, "%s#define BASE_TONE 1\n", light);
    HATCH_TRY(gpu_program_get(programs, &vertices, light, &state->vertices, err));
    HATCH_TRY(gpu_program_get(programs, &points, light, &state->points[0], err));
    HATCH_TRY(gpu_program_get(programs, &points, based, &state->points[1], err));
    const char *defines = state->style.pen.mark_px > 0 ? "#define MARKS 1\n" : "";
    HATCH_TRY(gpu_program_get(programs, &ribbon, defines, &state->ribbons[0], err));
    HATCH_TRY(gpu_program_get(programs, &curve, defines, &state->ribbons[1], err));
    return shaded_prepare(context, instance, err);
}

void traced_set_style(const struct frame *frame, double pen_px, struct traced_state *state)
{
    const struct hatch_stroke_pen even = even_pen(&state->style.pen);
    const struct hatch_stroke_pen *pen = pen_px > 0 ? &even : &state->style.pen;
    state->pen = *pen;
    state->pen.width_px = (float)(pen_px > 0 ? pen_px : width_px);
    float wider = state->pen.width_px / state->style.width_px; /* wider strokes have longer ends and marks */
    state->pen.mark_px *= wider;
    state->pen.gap_px *= wider;
    state->pen.taper_px *= wider;
    const bool dots = hatch_pen_has_dots(&state->pen);
    state->alike = pen_px > 0 && !dots;
    struct traced_block block = {
        .pen = {state->pen.width_px, pen->thin, (float)frame->request.canvas->side, tanf(pen->turn_rad)},
        .hand = {pen->vary, pen->pressure, pen->wobble_px, fmaxf(state->pen.taper_px, 1e-3f)},
        .ink = {pen_px > 0 ? 1 : state->style.ink, pen->grain, pen_px > 0 || dots ? 0 : (float)HATCH_STROKE_GRAZING},
        .marks = {state->pen.mark_px, state->pen.gap_px, pen->scatter, dots ? 1 : 0}};
    traced_set_look(&pen->look, (double)state->pen.width_px, pen_px > 0, &block);
    state->block = block;
    state->families = 0;
}

void traced_set_families(uint32_t families, struct traced_state *state)
{
    struct hatch_stroke_pen alone = state->pen;
    if (families == state->families)
        return;
    alone.join = fmaxf(alone.join, NARROW_JOIN);
    for (uint32_t f = 0; f < families; f++) {
        hatch_stroke_tones(&state->pen, families, f, state->block.tones[f]);
        hatch_stroke_tones(&alone, families, f, state->block.narrow[f]);
    }
    state->families = families;
    gpu_block_update(&state->block_buffer, BLOCK_TECHNIQUE, &state->block, sizeof state->block);
}

double traced_scale(const struct scene *scene, const struct hatch_item *item)
{
    double columns[3][3], largest = 0;
    if (item->deformed) {
        const struct hatch_item_rest rest = hatch_item_rest(&scene->unit, (uint32_t)(item - scene->unit.items));
        return rest.scale / rest.unit;
    }
    for (int c = 0; c < 3; c++)
        hatch_vec_of(item->to_unit + 4 * c, columns[c]);
    for (int c = 0; c < 3; c++) { /* no eigenvalue is greater than the largest sum of a row */
        double sum = 0;
        for (int k = 0; k < 3; k++)
            sum += fabs(hatch_vec_dot(columns[c], columns[k]));
        largest = fmax(largest, sum);
    }
    return sqrt(largest);
}

/* Returns a limit of the thresholds of all strokes that may be visible on an item, with the pen of the last
 * traced_set_style. */
static double threshold_limit(const struct frame *frame, const struct traced_state *state,
                              const struct hatch_item *item)
{
    const struct hatch_view *view = &frame->view;
    double unit = traced_scale(frame->scene, item), depth = HUGE_VAL;
    double height_px = frame->request.tile->full_height;
    if (item->deformed)
        return HUGE_VAL;
    for (int corner = 0; corner < 8; corner++) {
        double sum = 0;
        for (int k = 0; k < 3; k++)
            sum -= view->back[k] * ((corner >> k & 1 ? item->high[k] : item->low[k]) - view->eye[k]);
        depth = fmin(depth, sum);
    }
    if (view->orthographic)
        depth = 1;
    else if (depth < NARROWEST)
        return HUGE_VAL;
    return hatch_stroke_grazing(1, 1, HATCH_STROKE_GRAZING) * HATCH_STROKE_FADE * OFF_AXIS * unit * height_px /
           (2 * view->half_height * depth * (double)state->pen.width_px);
}

static void set_lift(const struct frame *frame, const struct hatch_item *item, double chord, GLuint program)
{
    const float *m = frame->block.clip_from_unit;
    float change[2] = {0, 0};
    for (int k = 0; k < 3; k++)
        for (int row = 0; row < 2; row++)
            change[row] += m[4 * k + 2 + row] * (float)frame->view.back[k];
    glProgramUniform4f(program, UNIFORM_LIFT, change[0], change[1], (float)chord, item->mirrored ? -1.0f : 1.0f);
}

/* Runs a compute pass over the vertices or the points of an item, whose buffers are bound. */
static void dispatch(const struct frame *frame, uint32_t index, const struct gpu_program *program, const char *name,
                     uint32_t count, GLbitfield barrier)
{
    const struct scene *scene = frame->scene;
    const struct frame_dispatch pass = {.name = name, .program = program, .barrier = barrier};
    frame_use_item(scene, index, frame->style.base_tone ? scene->items[index].base_lightness : 1.0f, program);
    glUniform1f(UNIFORM_SIDE, scene->unit.items[index].double_sided ? -1.0f : 1.0f);
    frame_dispatch_over(&pass, count, NULL);
}

void traced_place_vertices(const struct frame *frame, const struct traced_state *state, uint32_t index)
{
    const struct scene *scene = frame->scene;
    const struct hatch_item *item = &scene->unit.items[index];
    gpu_storage_bind(STORAGE_VERTICES, item->deformed ? scene->items[index].posed : scene->meshes[item->mesh].vertices);
    gpu_storage_bind(STORAGE_PLACED, state->items[index].placed);
    dispatch(frame, index, state->vertices, "vertices", scene->unit.meshes[item->mesh].mesh->vertex_count,
             GL_SHADER_STORAGE_BARRIER_BIT | GL_BUFFER_UPDATE_BARRIER_BIT);
}

uint32_t traced_place(const struct frame *frame, struct traced_state *state, uint32_t index, int ink, GLuint depths)
{
    const struct scene *scene = frame->scene;
    const struct hatch_item *item = &scene->unit.items[index];
    const struct traced_strokes *strokes = traced_strokes_of(frame, state, index);
    uint32_t count = strokes->count ? traced_count_under(strokes, threshold_limit(frame, state, item)) : 0;
    if (!count)
        return 0;
    bool based = frame->style.base_tone && scene->items[index].base_texture;
    GLuint program = state->points[based]->name;
    traced_set_families(state->strokes[item->mesh].families, state);
    if (ink == 0)
        traced_place_vertices(frame, state, index);
    gpu_storage_bind(STORAGE_VERTICES, item->deformed ? scene->items[index].posed : scene->meshes[item->mesh].vertices);
    gpu_storage_bind(STORAGE_PLACED, state->items[index].placed);
    gpu_storage_bind(STORAGE_POINTS, strokes->points);
    gpu_storage_bind(STORAGE_RIBBON, traced_ribbon_of(state, index)->buffer);
    glProgramUniform1i(program, UNIFORM_INK, ink);
    glProgramUniform1i(program, UNIFORM_DEPTHS, depths != 0);
    gpu_texture_bind(UNIT_TECHNIQUE + 1, depths, 0);
    glProgramUniform3f(program, UNIFORM_DENSEST, state->alike ? FLT_MAX : strokes->densest, strokes->raised,
                       state->strokes[item->mesh].coarsest);
    set_lift(frame, item, CHORD * (double)strokes->finest * traced_scale(scene, item), program);
    dispatch(frame, index, state->points[based], "points", strokes->end[count - 1], GL_TEXTURE_FETCH_BARRIER_BIT);
    return count;
}

static void draw_ribbons(const struct frame *frame, const struct traced_state *state, uint32_t index, uint32_t count,
                         int ink)
{
    const struct traced_strokes *strokes = traced_strokes_of(frame, state, index);
    const struct frame_pass pass = {.name = "strokes",
                                    .target = &frame->request.canvas->samples,
                                    .blend = FRAME_BLEND_OVER_COLOR,
                                    .depth = FRAME_DEPTH_BEFORE};
    frame_pass_begin(&pass);
    double limit = threshold_limit(frame, state, &frame->scene->unit.items[index]) * (double)strokes->finest;
    uint32_t parts = limit < SMOOTH ? 1 : limit < 4 * SMOOTH ? 2 : PARTS_MAX;
    glUseProgram(state->ribbons[parts > 1]->name);
    glUniform1i(UNIFORM_INK, ink);
    gpu_texture_bind(UNIT_TECHNIQUE, traced_ribbon_of(state, index)->view, 0);
    glVertexArrayElementBuffer(state->array, strokes->indices);
    glBindVertexArray(state->array);
    if (parts > 1) {
        glUniform1ui(UNIFORM_COUNT, parts);
        glDrawArraysInstanced(GL_TRIANGLES, 0, (GLsizei)(6 * strokes->end[count - 1]), (GLsizei)parts);
    } else
        glDrawElements(GL_TRIANGLES, (GLsizei)(6 * (strokes->end[count - 1] - count)), GL_UNSIGNED_INT, NULL);
}

/* Draws the surfaces as bare paper; only their depth where the background is paper already. */
static enum hatch_status draw_paper(struct frame *frame, const struct frame_shading *shading,
                                    struct traced_state *state, struct hatch_err *err)
{
    struct frame_shading paper = *shading;
    paper.passes[0].masks_color =
        memcmp(frame->request.background, frame->style.inks.paper, sizeof frame->style.inks.paper) == 0;
    return frame_draw_items(frame, &frame->request.canvas->samples, &paper, state->shaded.defines,
                            &state->shaded.shader, err);
}

static enum hatch_status draw(struct technique_context *context, struct technique_instance *instance,
                              struct hatch_err *err)
{
    const struct frame *frame = context->frame;
    struct traced_state *state = instance->state;
    HATCH_TRY(draw_paper(context->frame, &instance->technique->shading, state, err));
    glTextureBarrier(); /* points read the depths of the surfaces */
    traced_set_style(frame, 0, state);
    HATCH_TRY(traced_refine(context, state, err));
    for (uint32_t i = 0; i < state->item_count; i++)
        for (int ink = 0; ink < (frame->style.inks.two ? 2 : 1); ink++) {
            uint32_t count = traced_place(frame, state, i, ink, frame->request.canvas->samples.depth);
            gpu_timer_end_pass(frame->timer, "points");
            if (count)
                draw_ribbons(frame, state, i, count, ink);
            gpu_timer_end_pass(frame->timer, "strokes");
        }
    return HATCH_OK;
}

static struct hatch_line_brush line_brush(const struct technique_instance *instance)
{
    const struct traced_state *state = instance->state;
    struct hatch_line_brush brush = state->style.line_brush;
    brush.ink = state->style.ink;
    brush.pressure = LINE_PRESSURE * state->style.pen.pressure;
    brush.grain = state->style.pen.grain;
    return brush;
}

static void free_state(struct technique_instance *instance)
{
    struct traced_state *state = instance->state;
    for (uint32_t i = 0; i < state->mesh_count; i++) {
        traced_free_strokes(&state->strokes[i]);
        hatch_finer_free(state->finer[i]);
    }
    for (uint32_t i = 0; i < state->item_count; i++) {
        traced_forget(&state->items[i]);
        traced_free_ribbon(&state->items[i].ribbon);
        glDeleteBuffers(1, &state->items[i].placed);
    }
    glDeleteVertexArrays(1, &state->array);
    glDeleteBuffers(1, &state->block_buffer);
}

/* Points that near to a tile must have depths, which tell whether their strokes are hidden. */
static uint32_t reach_px(const struct technique_instance *instance)
{
    (void)instance;
    return DEPTHS_PX;
}

const struct technique technique_traced = {
    .name = "traced",
    .summary = "strokes that strokegen has traced on the meshes",
    .options = options,
    .params = params,
    .pen_option = "stroke-width",
    .features = TECHNIQUE_LINES | TECHNIQUE_PIXEL_LIGHT | TECHNIQUE_TRACED,
    .state_size = sizeof(struct traced_state),
    .shading = {.stages = {.vertex = "traced/paper.vert", .fragment = "traced/paper.frag"},
                .patches = FRAME_PATCHES_UNSEEN,
                .passes = {{.name = "paper", .depth = FRAME_DEPTH_NEARER}}},
    .check = check,
    .read = read_style,
    .prepare = prepare,
    .draw = draw,
    .curves = traced_curves,
    .line_brush = line_brush,
    .reach_px = reach_px,
    .free = free_state,
};
