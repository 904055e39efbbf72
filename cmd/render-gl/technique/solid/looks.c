/* The looks of solid textures: their passes over the items and over the image. */
#include <math.h>
#include <string.h>

#include "render-gl/gpu/bindings.h"
#include "render-gl/gpu/texture.h"
#include "render-gl/technique/solid/solid.h"

#define EDGE_PX 4.0 /* radius in which the pigment at the edges of washes has gathered */

struct frame_shading solid_look_shading(enum solid_look look, bool flat)
{
    static const struct {
        const char *name, *fragment;
        enum frame_patches patches; /* of flat textures */
    } looks[] = {[SOLID_PLAIN] = {"plain", "solid/plain.frag", FRAME_PATCHES_BLEND},
                 [SOLID_BINARY] = {"binary", "solid/binary.frag", FRAME_PATCHES_BLEND},
                 [SOLID_WATERCOLOR] = {"marks", "solid/marks.frag", FRAME_PATCHES_COVER},
                 [SOLID_COLLAGE] = {"strips", "solid/collage.frag", FRAME_PATCHES_COVER}};
    return (struct frame_shading){
        .stages = {.vertex = flat ? "rptam/rptam.vert" : "solid/solid.vert", .fragment = looks[look].fragment},
        .defines = !flat                  ? NULL
                   : look == SOLID_BINARY ? "#define FLAT 1\n#define THRESHOLD 1\n"
                                          : "#define FLAT 1\n",
        .pixel_light = true,
        .pieces = true,
        .patches = flat ? looks[look].patches : FRAME_PATCHES_UNSEEN,
        .passes = {{.name = looks[look].name, .depth = FRAME_DEPTH_NEARER}}};
}

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

static enum hatch_status program_of(struct frame *frame, const struct pass *pass, const struct gpu_program **program,
                                    struct hatch_err *err)
{
    const struct gpu_stages stages = {.vertex = "canvas/screen.vert", .fragment = pass->fragment};
    return gpu_program_get(&frame->programs, &stages, "", program, err);
}

enum hatch_status solid_look_prepare(struct frame *frame, enum solid_look look, struct hatch_err *err)
{
    static const int first[] = {[SOLID_WATERCOLOR] = WASH, [SOLID_COLLAGE] = WIDTHS};
    static const int last[] = {[SOLID_WATERCOLOR] = SPREAD, [SOLID_COLLAGE] = PASTE};
    const struct gpu_program *program;
    for (int i = first[look]; (look == SOLID_WATERCOLOR || look == SOLID_COLLAGE) && i <= last[look]; i++)
        HATCH_TRY(program_of(frame, &passes[i], &program, err));
    return HATCH_OK;
}

/* Runs a pass over the image.
 *   along   direction; NULL for passes that have none
 *   radius  samples; 0 for passes that have none
 *   target  out: its transient target, or the canvas */
static enum hatch_status run(struct frame *frame, int which, const GLint along[2], double radius,
                             const struct gpu_target **target, struct hatch_err *err)
{
    const struct pass *pass = &passes[which];
    const struct gpu_target *canvas = &frame->request.canvas->samples;
    uint32_t side = pass->pixels ? frame->request.canvas->side : 1;
    struct gpu_target_form form = {.width = canvas->form.width / side, .height = canvas->form.height / side};
    memcpy(form.outputs, pass->outputs, sizeof pass->outputs);
    const struct gpu_program *program;
    *target = canvas;
    HATCH_TRY(program_of(frame, pass, &program, err));
    if (pass->outputs[0])
        HATCH_TRY(frame_target(&frame->targets, &form, target, err));
    const struct frame_pass screen = {
        .name = pass->name, .target = *target, .depth = pass->outputs[0] ? FRAME_DEPTH_NONE : FRAME_DEPTH_NEARER};
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
static enum hatch_status run_both(struct frame *frame, int which, GLuint from, double radius,
                                  const struct gpu_target **target, struct hatch_err *err)
{
    static const GLint along[2][2] = {{0, 1}, {1, 0}};
    gpu_texture_bind(UNIT_SOURCE, from, 0);
    HATCH_TRY(run(frame, which, along[0], radius, target, err));
    gpu_texture_bind(UNIT_SOURCE, (*target)->outputs[0], 0);
    return run(frame, which, along[1], radius, target, err);
}

/* Draws the items into a target with three outputs and depth, and binds them for the passes over the image. */
static enum hatch_status draw_items(struct frame *frame, struct shaded_state *shaded,
                                    const struct frame_shading *shading, const struct gpu_target **target,
                                    struct hatch_err *err)
{
    static const float far = 0;
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
    HATCH_TRY(frame_draw_items(frame, *target, shading, shaded->defines, &shaded->shader, err));
    gpu_texture_bind(UNIT_TECHNIQUE + 1, (*target)->outputs[0], 0);
    gpu_texture_bind(UNIT_TECHNIQUE + 2, (*target)->outputs[1], 0);
    gpu_texture_bind(UNIT_TECHNIQUE + 4, (*target)->depth, 0);
    gpu_texture_bind(UNIT_TONES, (*target)->outputs[2], 0);
    return HATCH_OK;
}

static enum hatch_status draw_watercolor(struct frame *frame, struct shaded_state *shaded,
                                         const struct frame_shading *shading, struct hatch_err *err)
{
    const struct gpu_target *marks, *wash, *blurred, *painted, *canvas;
    HATCH_TRY(draw_items(frame, shaded, shading, &marks, err));
    HATCH_TRY(run(frame, WASH, NULL, 0, &wash, err));
    HATCH_TRY(run_both(frame, BLUR, wash->outputs[0], EDGE_PX, &blurred, err));
    gpu_texture_bind(UNIT_TECHNIQUE + 1, wash->outputs[0], 0);
    gpu_texture_bind(UNIT_TONES, wash->outputs[1], 0);
    gpu_texture_bind(UNIT_TECHNIQUE + 2, wash->outputs[2], 0);
    gpu_texture_bind(UNIT_TECHNIQUE + 3, blurred->outputs[0], 0);
    HATCH_TRY(run(frame, WATERCOLOR, NULL, 0, &painted, err));
    gpu_texture_bind(UNIT_TECHNIQUE + 3, painted->outputs[0], 0);
    return run(frame, SPREAD, NULL, 0, &canvas, err);
}

static enum hatch_status draw_collage(struct frame *frame, struct shaded_state *shaded,
                                      const struct frame_shading *shading, struct hatch_err *err)
{
    const struct gpu_target *strips, *widths, *mended, *ranges, *canvas;
    double border = solid_options.border_px * frame->request.canvas->side;
    HATCH_TRY(draw_items(frame, shaded, shading, &strips, err));
    gpu_texture_bind(UNIT_SOURCE, strips->outputs[1], 0);
    HATCH_TRY(run(frame, WIDTHS, NULL, border, &widths, err));
    gpu_texture_bind(UNIT_SOURCE, widths->outputs[0], 0);
    HATCH_TRY(run(frame, MEND, NULL, border, &mended, err));
    gpu_texture_bind(UNIT_TECHNIQUE + 3, mended->outputs[1], 0);
    HATCH_TRY(run_both(frame, STRIPS, mended->outputs[0], 0, &ranges, err));
    gpu_texture_bind(UNIT_TECHNIQUE + 2, ranges->outputs[0], 0);
    return run(frame, PASTE, NULL, 0, &canvas, err);
}

enum hatch_status solid_look_draw(struct frame *frame, enum solid_look look, struct shaded_state *shaded,
                                  const struct frame_shading *shading, struct hatch_err *err)
{
    if (look == SOLID_WATERCOLOR)
        return draw_watercolor(frame, shaded, shading, err);
    if (look == SOLID_COLLAGE)
        return draw_collage(frame, shaded, shading, err);
    return frame_draw_items(frame, &frame->request.canvas->samples, shading, shaded->defines, &shaded->shader, err);
}

uint32_t solid_look_reach_px(enum solid_look look)
{
    if (look == SOLID_WATERCOLOR)
        return (uint32_t)ceil(solid_options.wobble_px + EDGE_PX) + 1;
    return look == SOLID_COLLAGE ? (uint32_t)ceil(10 * solid_options.border_px) + 2 : 0;
}
