/* The passes of looks over the image. */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "render-gl/gpu/bindings.h"
#include "render-gl/gpu/texture.h"
#include "render-gl/look/look.h"

#define EDGE_PX 4.0 /* radius in which the pigment at the edges of washes has gathered */

/* A pass over the image. */
struct pass {
    const char *name, *fragment;
    GLenum outputs[3]; /* formats of its transient target; 0: it draws into the canvas */
    bool pixels;       /* the target has texels for pixels; false: for samples */
};

enum { WASH, BLUR, WATERCOLOR, SPREAD, WIDTHS, MEND, STRIPS, PASTE };
static const struct pass passes[] = {[WASH] = {"wash", "solid/wash.frag", {GL_RGBA16F, GL_RGBA16F, GL_RGBA16F}, true},
                                     [BLUR] = {"blur", "solid/blur.frag", {GL_RGBA16F}, true},
                                     [WATERCOLOR] = {"paint", "solid/watercolor.frag", {GL_RGBA16F}, true},
                                     [SPREAD] = {"spread", "solid/spread.frag", {0}, false},
                                     [WIDTHS] = {"widths", "solid/widths.frag", {GL_RGBA16F}, false},
                                     [MEND] = {"mend", "solid/mend.frag", {GL_RGBA16F, GL_RGBA16F}, false},
                                     [STRIPS] = {"borders", "solid/strips.frag", {GL_RGBA16F}, false},
                                     [PASTE] = {"paste", "solid/paste.frag", {0}, false}};

/* A frame that is drawn in a look. */
struct drawing {
    struct look *look;
    struct frame *frame;
};

static enum hatch_status program_of(const struct look *look, struct frame *frame, const struct pass *pass,
                                    const struct gpu_program **program, struct hatch_err *err)
{
    const struct gpu_stages stages = {.vertex = "canvas/screen.vert", .fragment = pass->fragment};
    char defines[LOOK_DEFINES_BYTES];
    snprintf(defines, sizeof defines, "%s%s", look->paints ? "#define PICTURE 1\n" : "",
             look_options.colors ? "#define COLORS 1\n" : "");
    return gpu_program_get(&frame->programs, &stages, defines, program, err);
}

enum hatch_status look_passes_prepare(const struct look *look, struct frame *frame, struct hatch_err *err)
{
    static const int first[] = {[LOOK_WATERCOLOR] = WASH, [LOOK_COLLAGE] = WIDTHS};
    static const int last[] = {[LOOK_WATERCOLOR] = SPREAD, [LOOK_COLLAGE] = PASTE};
    const struct gpu_program *program;
    bool has = look->kind == LOOK_WATERCOLOR || look->kind == LOOK_COLLAGE;
    for (int i = first[look->kind]; has && i <= last[look->kind]; i++)
        HATCH_TRY(program_of(look, frame, &passes[i], &program, err));
    return HATCH_OK;
}

/* Runs a pass over the image.
 *   along   direction; NULL for passes that have none
 *   radius  samples; 0 for passes that have none
 *   target  out: its transient target, or the canvas */
static enum hatch_status run(struct drawing drawing, int which, const GLint along[2], double radius,
                             const struct gpu_target **target, struct hatch_err *err)
{
    const struct pass *pass = &passes[which];
    struct frame *frame = drawing.frame;
    const struct gpu_target *canvas = &frame->request.canvas->samples;
    uint32_t side = pass->pixels ? frame->request.canvas->side : 1;
    struct gpu_target_form form = {.width = canvas->form.width / side, .height = canvas->form.height / side};
    memcpy(form.outputs, pass->outputs, sizeof pass->outputs);
    const struct gpu_program *program;
    *target = canvas;
    HATCH_TRY(program_of(drawing.look, frame, pass, &program, err));
    if (pass->outputs[0])
        HATCH_TRY(frame_target(&frame->targets, &form, target, err));
    bool sets_depth = !pass->outputs[0] && !drawing.look->paints; /* a picture has its depth */
    const struct frame_pass screen = {
        .name = pass->name, .target = *target, .depth = sets_depth ? FRAME_DEPTH_NEARER : FRAME_DEPTH_NONE};
    if (along)
        glProgramUniform2iv(program->name, UNIFORM_A, 1, along);
    if (radius > 0)
        glProgramUniform1f(program->name, UNIFORM_B, (float)radius);
    frame_pass_begin(&screen);
    frame_pass_screen(program);
    frame_pass_end(&screen, frame->timer);
    return HATCH_OK;
}

/* Runs a pass along y and then along x. */
static enum hatch_status run_both(struct drawing drawing, int which, GLuint from, double radius,
                                  const struct gpu_target **target, struct hatch_err *err)
{
    static const GLint along[2][2] = {{0, 1}, {1, 0}};
    gpu_texture_bind(UNIT_SOURCE, from, 0);
    HATCH_TRY(run(drawing, which, along[0], radius, target, err));
    gpu_texture_bind(UNIT_SOURCE, (*target)->outputs[0], 0);
    return run(drawing, which, along[1], radius, target, err);
}

/* Draws the items into a target with three outputs and depth, and binds them for the passes over the image. */
static enum hatch_status draw_items(struct drawing drawing, const struct gpu_target **target, struct hatch_err *err)
{
    static const float far = 0;
    struct look *look = drawing.look;
    struct frame *frame = drawing.frame;
    const struct gpu_target *canvas = &frame->request.canvas->samples;
    const struct gpu_target_form form = {.width = canvas->form.width,
                                         .height = canvas->form.height,
                                         .outputs = {GL_RGBA16F, GL_RGBA16F, GL_RGBA16F},
                                         .depth = GL_DEPTH_COMPONENT32F};
    HATCH_TRY(frame_target(&frame->targets, &form, target, err));
    const struct frame_pass clear = {.name = "clear", .target = *target, .clear_depth = &far};
    frame_pass_begin(&clear);
    for (uint32_t i = 0; i < 3; i++)
        gpu_target_clear(*target, i, GL_RGBA, GL_FLOAT, NULL);
    frame_pass_end(&clear, frame->timer);
    HATCH_TRY(frame_draw_items(frame, *target, &look->shading, look->defines, &look->shader, err));
    gpu_texture_bind(UNIT_TECHNIQUE + 1, look->paints ? canvas->outputs[0] : (*target)->outputs[0], 0);
    gpu_texture_bind(UNIT_TECHNIQUE + 2, (*target)->outputs[1], 0);
    gpu_texture_bind(UNIT_TECHNIQUE + 4, (*target)->depth, 0);
    gpu_texture_bind(UNIT_TONES, (*target)->outputs[2], 0);
    return HATCH_OK;
}

static enum hatch_status draw_watercolor(struct drawing drawing, struct hatch_err *err)
{
    const struct gpu_target *marks, *wash, *blurred, *painted, *canvas;
    HATCH_TRY(draw_items(drawing, &marks, err));
    HATCH_TRY(run(drawing, WASH, NULL, 0, &wash, err));
    HATCH_TRY(run_both(drawing, BLUR, wash->outputs[0], EDGE_PX, &blurred, err));
    gpu_texture_bind(UNIT_TECHNIQUE + 1, wash->outputs[0], 0);
    gpu_texture_bind(UNIT_TONES, wash->outputs[1], 0);
    gpu_texture_bind(UNIT_TECHNIQUE + 2, wash->outputs[2], 0);
    gpu_texture_bind(UNIT_TECHNIQUE + 3, blurred->outputs[0], 0);
    HATCH_TRY(run(drawing, WATERCOLOR, NULL, 0, &painted, err));
    gpu_texture_bind(UNIT_TECHNIQUE + 3, painted->outputs[0], 0);
    return run(drawing, SPREAD, NULL, 0, &canvas, err);
}

static enum hatch_status draw_collage(struct drawing drawing, struct hatch_err *err)
{
    const struct gpu_target *strips, *widths, *mended, *ranges, *canvas;
    double border = look_options.border_px * drawing.frame->request.canvas->side;
    HATCH_TRY(draw_items(drawing, &strips, err));
    gpu_texture_bind(UNIT_SOURCE, strips->outputs[1], 0);
    HATCH_TRY(run(drawing, WIDTHS, NULL, border, &widths, err));
    gpu_texture_bind(UNIT_SOURCE, widths->outputs[0], 0);
    HATCH_TRY(run(drawing, MEND, NULL, border, &mended, err));
    gpu_texture_bind(UNIT_TECHNIQUE + 3, mended->outputs[1], 0);
    HATCH_TRY(run_both(drawing, STRIPS, mended->outputs[0], 0, &ranges, err));
    gpu_texture_bind(UNIT_TECHNIQUE + 2, ranges->outputs[0], 0);
    return run(drawing, PASTE, NULL, 0, &canvas, err);
}

enum hatch_status look_passes_draw(struct look *look, struct frame *frame, struct hatch_err *err)
{
    const struct drawing drawing = {look, frame};
    if (look->kind == LOOK_WATERCOLOR)
        return draw_watercolor(drawing, err);
    if (look->kind == LOOK_COLLAGE)
        return draw_collage(drawing, err);
    return frame_draw_items(frame, &frame->request.canvas->samples, &look->shading, look->defines, &look->shader, err);
}

uint32_t look_reach_px(enum look_kind kind)
{
    if (kind == LOOK_WATERCOLOR)
        return (uint32_t)ceil(look_options.wobble_px + EDGE_PX) + 1;
    return kind == LOOK_COLLAGE ? (uint32_t)ceil(10 * look_options.border_px) + 2 : 0;
}
