#include "render-gl/technique/strokes/strokes.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "placement/style.h"
#include "render-gl/gpu/bindings.h"
#include "render-gl/gpu/buffer.h"
#include "render-gl/gpu/texture.h"
#include "render-gl/technique/list.h"
#include "render-gl/technique/traced/traced.h"

#define THINNEST 0.7 /* mean width under which strokes get shorter instead of thinner, in that of whole strokes */

#define FORESHORTENED 2.5 /* greatest length of a stroke in perspective, in its own lengths */

#define MOST_STROKES 1048576

static int64_t most_strokes = 65536;
static int aggregate; /* 0: sort, 1: blend */
static const char *const aggregates[] = {"sort", "blend", NULL};
static double overdraw_px = 4;

static const struct cmd_option options[] = {
    {0, "overdraw", CMD_REAL, 0, 1024, "PX",
     "+strokes: length by which strokes go on where they are cut off (default 4)", &overdraw_px, NULL, NULL},
    {0, "most-strokes", CMD_INT, 1, MOST_STROKES, "N",
     "+strokes: number of strokes that are drawn, the largest first (default 65536)", &most_strokes, NULL, NULL},
    {0, "aggregate", CMD_CHOICE, 0, 0, "HOW",
     "+strokes: collect the pixels of a stroke by sorting them, or by blending: sort or blend (default sort)",
     &aggregate, aggregates, NULL},
    {0},
};
static const struct technique_param params[] = {{"overdraw", false, 1}, {0}};

const struct frame_shading strokes_paper = {.stages = {.vertex = "traced/paper.vert", .fragment = "traced/paper.frag"},
                                            .patches = FRAME_PATCHES_UNSEEN,
                                            .passes = {{.name = "paper", .depth = FRAME_DEPTH_NEARER}}};

/* Returns whether strokes that cross are no darker than the darker one of them, as those of the map. */
static bool is_flat(const struct technique_instance *instance)
{
    return instance->tones && instance->tones->flat;
}

static enum hatch_status prepare(struct technique_context *context, struct technique_instance *instance,
                                 struct hatch_err *err)
{
    static const struct gpu_stages route = {.compute = "strokes/route.comp"};
    static const struct gpu_stages sort = {.compute = "strokes/sort.comp"};
    static const struct gpu_stages fit = {.compute = "strokes/fit.comp"};
    static const struct gpu_stages extrude = {.compute = "strokes/extrude.comp"};
    static const struct gpu_stages points = {.vertex = "strokes/blend.vert", .fragment = "strokes/blend.frag"};
    static const struct gpu_stages waiting = {.compute = "strokes/waiting.comp"};
    static const struct gpu_stages fit_blend = {.compute = "strokes/fit_blend.comp"};
    static const struct gpu_stages ribbon = {.vertex = "traced/ribbon.vert", .fragment = "traced/ribbon.frag"};
    static const struct gpu_stages over = {.vertex = "canvas/screen.vert", .fragment = "canvas/over.frag"};
    struct gpu_programs *programs = &context->frame->programs;
    struct strokes_state *state = instance->state;
    const char *crossing = is_flat(instance) ? "#define FLAT 1\n" : "";
    const char *magnified = instance->tones ? "#define MAGNIFIED 1\n" : "";
    char defines[64];
    state->blends = aggregate == 1;
    HATCH_TRY(gpu_program_get(programs, &route, "", &state->route, err));
    HATCH_TRY(gpu_program_get(programs, &sort, "", &state->sort, err));
    HATCH_TRY(gpu_program_get(programs, &points, "", &state->blend.points, err));
    HATCH_TRY(gpu_program_get(programs, &waiting, "", &state->blend.waiting, err));
    strokes_take_brush(state);
    snprintf(defines, sizeof defines, "#define FITTED 1\n%s%s", state->has_brush ? "#define BRUSH 1\n" : "", crossing);
    HATCH_TRY(gpu_program_get(programs, state->blends ? &fit_blend : &fit, magnified, &state->fit, err));
    HATCH_TRY(gpu_program_get(programs, &extrude, crossing, &state->extrude, err));
    HATCH_TRY(gpu_program_get(programs, &ribbon, defines, &state->ribbon, err));
    HATCH_TRY(gpu_program_get(programs, &over, "", &state->over, err));
    HATCH_TRY(frame_shader_prepare(context->frame, &strokes_paper, "", &state->paper, err));
    if (!state->array)
        glCreateVertexArrays(1, &state->array);
    return strokes_prepare_source(context, instance, err);
}

/* Writes the block of the style.
 *   pen_px  as in strokes_find */
static void set_style(const struct frame *frame, double pen_px, const struct technique_instance *instance)
{
    struct strokes_state *state = instance->state;
    const bool even = pen_px > 0;
    const struct hatch_stroke_pen *pen = &state->seeds.source.drawing.pen;
    struct strokes_look look = strokes_look(instance);
    struct traced_block block = {
        .pen = {look.width_px, 1, (float)frame->request.canvas->side, 0},
        .hand = {even ? 0 : pen->vary, even ? 0 : pen->pressure, pen->wobble_px,
                 fmaxf(pen->taper_px * look.width_px / state->seeds.source.drawing.width_px, 1e-3f)},
        .ink = {look.ink, state->has_brush ? 0 : pen->grain}};
    traced_set_look(&pen->look, even ? pen_px : (double)look.width_px, even, &block);
    block.zigzag[2] = look.length_px / fmaxf(block.zigzag[1], 1e-6f);
    memcpy(state->zigzag, block.zigzag, sizeof state->zigzag);
    gpu_block_update(&state->block_buffer, BLOCK_TECHNIQUE, &block, sizeof block);
}

/* Makes the indices of the triangles of at least so many ribbons. */
static enum hatch_status make_indices(struct strokes_state *state, uint32_t count, struct hatch_arena *scratch,
                                      struct hatch_err *err)
{
    const size_t each = 6 * (RIBBON_POINTS - 1);
    struct hatch_arena_mark mark = hatch_arena_mark(scratch);
    uint32_t *indices;
    if (state->indices.size_bytes >= sizeof *indices * each * count)
        return HATCH_OK;
    HATCH_TRY(HATCH_ALLOC_UNSET(scratch, &indices, each * count, err));
    for (uint32_t i = 0; i < count; i++)
        for (uint32_t k = 0; k + 1 < RIBBON_POINTS; k++) {
            uint32_t left = 2 * (i * RIBBON_POINTS + k);
            const uint32_t two[6] = {left, left + 1, left + 2, left + 2, left + 1, left + 3};
            memcpy(indices + each * i + 6 * (size_t)k, two, sizeof two);
        }
    strokes_reserve(&state->indices, sizeof *indices * each * count);
    gpu_buffer_update(state->indices.name, indices, sizeof *indices * each * count);
    hatch_arena_rewind(scratch, mark);
    return gpu_check_memory(err, "%u strokes", count);
}

static bool is_drawn(const struct strokes_list *list, uint32_t i)
{
    return !list->lasts || list->lasts[i];
}

/* Draws the ribbons in a pass that has begun. */
static void draw_ribbons(const struct strokes_state *state, const struct strokes_list *list)
{
    const uint32_t each = 6 * (RIBBON_POINTS - 1);
    uint32_t first = 0;
    glUseProgram(state->ribbon->name);
    gpu_texture_bind(UNIT_TECHNIQUE, state->points_view, 0);
    strokes_bind_brush(state);
    glVertexArrayElementBuffer(state->array, state->indices.name);
    glBindVertexArray(state->array);
    while (first < list->count) {
        uint32_t end = first, ink = list->strokes[first].id[0] & 1;
        while (end < list->count && (list->strokes[end].id[0] & 1) == ink && is_drawn(list, end))
            end++;
        if (end == first) {
            first++;
            continue;
        }
        glUniform1i(UNIFORM_INK, (GLint)ink);
        glDrawElements(GL_TRIANGLES, (GLsizei)(each * (end - first)), GL_UNSIGNED_INT,
                       (const void *)(sizeof(uint32_t) * each * first));
        first = end;
    }
}

/* Draws the ribbons over the canvas, each over those before it. */
static enum hatch_status draw_over(const struct frame *frame, const struct strokes_state *state,
                                   const struct strokes_list *list)
{
    const struct frame_pass pass = {
        .name = "strokes", .target = &frame->request.canvas->samples, .blend = FRAME_BLEND_OVER_COLOR};
    frame_pass_begin(&pass);
    draw_ribbons(state, list);
    frame_pass_end(&pass, frame->timer);
    return HATCH_OK;
}

/* Draws the ribbons over the canvas, at each sample the one that covers it most. */
static enum hatch_status draw_flat(struct frame *frame, const struct strokes_state *state,
                                   const struct strokes_list *list, struct hatch_err *err)
{
    static const float none[4] = {0}, far = 0;
    const struct gpu_target *canvas = &frame->request.canvas->samples, *strokes;
    const struct gpu_target_form form = {.width = canvas->form.width,
                                         .height = canvas->form.height,
                                         .outputs = {GL_RGBA16F},
                                         .depth = GL_DEPTH_COMPONENT32F};
    HATCH_TRY(frame_target(&frame->targets, &form, &strokes, err));
    const struct frame_pass most = {.target = strokes, .depth = FRAME_DEPTH_NEARER, .clear = none, .clear_depth = &far};
    const struct frame_pass over = {.name = "strokes", .target = canvas, .blend = FRAME_BLEND_OVER_COLOR};
    frame_pass_begin(&most);
    draw_ribbons(state, list);
    frame_pass_begin(&over);
    gpu_texture_bind(UNIT_SOURCE, strokes->outputs[0], 0);
    frame_pass_screen(state->over);
    frame_pass_end(&over, frame->timer);
    return HATCH_OK;
}

/* Makes the texture's strokes those of a pen, which draws a stroke whole or not at all: they fade one by one, and have
 * the pen's ink, although they taper and have a grain. */
static enum hatch_status take_pen(struct technique_context *context, struct technique_instance *instance, double pen_px,
                                  struct hatch_err *err)
{
    const struct rptam_source *source = &((struct strokes_state *)instance->state)->seeds.source;
    const struct rptam_stroke *stroke = &source->stroke;
    double *width_px = &rptam_options.stroke_px[1];
    double wanted_px = pen_px * hatch_zigzag_stretch(&source->drawing.pen.look) /
                       fmax(rptam_mean_ink(&stroke->alpha, &stroke->grain), 1e-3);
    if (!(fabs(wanted_px - *width_px) > 0) && !(rptam_options.overlap > 0))
        return HATCH_OK;
    *width_px = wanted_px;
    rptam_options.overlap = 0;
    rptam_options.ink = 1;
    return rptam_changed(context, instance, err);
}

/* Applies the options to the strokes of a frame. */
static enum hatch_status begin(struct technique_context *context, struct technique_instance *instance, double pen_px,
                               struct hatch_err *err)
{
    struct strokes_state *state = instance->state;
    if (pen_px > 0 && !instance->tones)
        HATCH_TRY(take_pen(context, instance, pen_px, err));
    state->most = (uint32_t)most_strokes;
    state->width_px = (double)strokes_look(instance).width_px;
    return HATCH_OK;
}

enum hatch_status strokes_find(struct technique_context *context, struct technique_instance *instance, double pen_px,
                               struct strokes_list *list, struct hatch_err *err)
{
    struct strokes_state *state = instance->state;
    struct hatch_arena *scratch = &context->args->scratch;
    HATCH_TRY(begin(context, instance, pen_px, err));
    HATCH_TRY(strokes_gather(context, instance, list, err));
    state->found_count = 0;
    if (!list->count)
        return HATCH_OK;
    set_style(context->frame, pen_px, instance);
    double least_px = THINNEST * state->width_px * strokes_use_brush(state, pen_px > 0);
    glProgramUniform1f(state->extrude->name, UNIFORM_OVERDRAW, (float)overdraw_px);
    glProgramUniform1f(state->extrude->name, UNIFORM_MARGIN, (float)state->margin_px);
    glProgramUniform1f(state->extrude->name, UNIFORM_THINNEST, pen_px > 0 ? 0 : (float)least_px);
    state->counts.strokes += list->count;
    HATCH_TRY(strokes_fit(context->frame, state, list, cmd_pool(context->args), scratch, err));
    state->counts.fragments += list->fragments;
    state->counts.waited += state->waited;
    return HATCH_OK;
}

enum hatch_status strokes_take(struct technique_context *context, struct technique_instance *instance, double pen_px,
                               struct strokes_list *list, struct hatch_err *err)
{
    struct strokes_state *state = instance->state;
    if (!context->frame->request.film)
        return strokes_find(context, instance, pen_px, list, err);
    HATCH_TRY(begin(context, instance, pen_px, err));
    HATCH_TRY(strokes_recall(context, instance, list, err));
    if (list->count)
        set_style(context->frame, pen_px, instance);
    strokes_use_brush(state, pen_px > 0);
    return HATCH_OK;
}

static enum hatch_status draw(struct technique_context *context, struct technique_instance *instance,
                              struct hatch_err *err)
{
    struct strokes_state *state = instance->state;
    struct frame *frame = context->frame;
    struct hatch_arena *scratch = &context->args->scratch;
    struct hatch_arena_mark mark = hatch_arena_mark(scratch);
    struct strokes_list list;
    HATCH_TRY(frame_draw_items(frame, &frame->request.canvas->samples, &strokes_paper, "", &state->paper, err));
    enum hatch_status status = strokes_take(context, instance, 0, &list, err);
    if (status == HATCH_OK)
        status = make_indices(state, list.count, scratch, err);
    if (status == HATCH_OK && list.count)
        status = is_flat(instance) ? draw_flat(frame, state, &list, err) : draw_over(frame, state, &list);
    hatch_arena_rewind(scratch, mark);
    return status;
}

static struct technique_counts count(struct technique_instance *instance)
{
    struct strokes_state *state = instance->state;
    const struct technique_counts counts = state->counts;
    state->counts = (struct technique_counts){.strokes = 0};
    return counts;
}

/* A stroke is found only where it is gathered whole. */
static uint32_t reach_px(const struct technique_instance *instance)
{
    const struct strokes_state *state = instance->state;
    double longest_px = 0;
    for (uint32_t i = 0; i < state->seeds.model->layer_count; i++)
        longest_px = fmax(longest_px, state->seeds.model->layers[i].style.length_px);
    return (uint32_t)ceil(FORESHORTENED * longest_px + overdraw_px);
}

static void free_state(struct technique_instance *instance)
{
    struct strokes_state *state = instance->state;
    const GLuint buffers[] = {state->fragments.name, state->table.name,   state->sorted.name,  state->found.name,
                              state->missed.name,    state->order.name,   state->divided.name, state->drawn.name,
                              state->points.name,    state->indices.name, state->block_buffer};
    glDeleteBuffers(sizeof buffers / sizeof *buffers, buffers);
    glDeleteTextures(1, &state->points_view);
    glDeleteTextures(2, state->brush);
    glDeleteVertexArrays(1, &state->array);
    strokes_blend_free(&state->blend);
    strokes_film_free(state);
    rptam_free(instance);
}

/* Tonal art maps with image-space strokes (Szécsi, Szirányi & Kacsó). */
const struct technique technique_strokes = {
    .name = "strokes",
    .summary = "curves fitted to the strokes of a texture: whole strokes, by any brush",
    .options = options,
    .shared = rptam_option_table,
    .params = params,
    .extra = &asset_strokes,
    .features = TECHNIQUE_STROKES | TECHNIQUE_PIXEL_LIGHT,
    .places = HATCH_NEAR_TEXCOORDS,
    .state_size = sizeof(struct strokes_state),
    .shading = {.stages = {.vertex = "rptam/rptam.vert", .fragment = "strokes/gather.frag"},
                .defines = "#define GATHERS 1\n",
                .pixel_light = true,
                .smooth = true,
                .patches = FRAME_PATCHES_COVER,
                .passes = {{.name = "gather", .depth = FRAME_DEPTH_EQUAL}}},
    .read = rptam_read,
    .prepare = prepare,
    .draw = draw,
    .count = count,
    .foresee = strokes_foresee,
    .curves = strokes_curves,
    .reach_px = reach_px,
    .changed = rptam_changed,
    .darkest = rptam_darkest,
    .free = free_state,
};
