/* The look of watercolours (section 4.1; Bousseau et al. 2006). */
#include <math.h>

#include "render-gl/gpu/bindings.h"
#include "render-gl/gpu/texture.h"
#include "render-gl/look/passes.h"

#define EDGE_PX 4.0 /* radius in which the pigment at the edges of washes has gathered */

enum { WASH, BLUR, PAINT, SPREAD, PASS_COUNT };
static const struct look_pass passes[PASS_COUNT] = {
    [WASH] = {"wash", "solid/wash.frag", {GL_RGBA16F, GL_RGBA16F, GL_RGBA16F}, true, 0},
    [BLUR] = {"blur", "solid/blur.frag", {GL_RGBA16F}, true, LOOK_ALONG | LOOK_RADIUS},
    [PAINT] = {"paint", "solid/watercolor.frag", {GL_RGBA16F}, true, 0},
    [SPREAD] = {"spread", "solid/spread.frag", {0}, false, 0}};

enum hatch_status look_watercolor_prepare(const struct look *look, struct frame *frame, struct hatch_err *err)
{
    return look_passes_compile(look, frame, passes, PASS_COUNT, err);
}

/* Draws the items into a target with three outputs and depth, and binds them for the passes over the image. */
static enum hatch_status draw_marks(struct look_drawing drawing, struct hatch_err *err)
{
    const struct gpu_target *canvas = &drawing.frame->request.canvas->samples, *marks;
    const struct gpu_target_form form = {.width = canvas->form.width,
                                         .height = canvas->form.height,
                                         .outputs = {GL_RGBA16F, GL_RGBA16F, GL_RGBA16F},
                                         .depth = GL_DEPTH_COMPONENT32F};
    HATCH_TRY(look_draw_items(drawing, &form, &drawing.look->shading, &drawing.look->shader, &marks, err));
    gpu_texture_bind(UNIT_TECHNIQUE + 1, drawing.look->paints ? canvas->outputs[0] : marks->outputs[0], 0);
    gpu_texture_bind(UNIT_TECHNIQUE + 2, marks->outputs[1], 0);
    gpu_texture_bind(UNIT_TECHNIQUE + 4, marks->depth, 0);
    gpu_texture_bind(UNIT_TONES, marks->outputs[2], 0);
    return HATCH_OK;
}

enum hatch_status look_watercolor_draw(struct look_drawing drawing, struct hatch_err *err)
{
    const struct gpu_target *wash, *blurred, *painted;
    HATCH_TRY(draw_marks(drawing, err));
    HATCH_TRY(look_pass_add(drawing, &passes[WASH], NULL, &wash, err));
    HATCH_TRY(look_pass_both(drawing, &passes[BLUR], wash->outputs[0], EDGE_PX, &blurred, err));
    gpu_texture_bind(UNIT_TECHNIQUE + 1, wash->outputs[0], 0);
    gpu_texture_bind(UNIT_TONES, wash->outputs[1], 0);
    gpu_texture_bind(UNIT_TECHNIQUE + 2, wash->outputs[2], 0);
    gpu_texture_bind(UNIT_TECHNIQUE + 3, blurred->outputs[0], 0);
    HATCH_TRY(look_pass_add(drawing, &passes[PAINT], NULL, &painted, err));
    gpu_texture_bind(UNIT_TECHNIQUE + 3, painted->outputs[0], 0);
    return look_pass_run(drawing, &passes[SPREAD], NULL, NULL, err);
}

uint32_t look_watercolor_reach_px(void)
{
    return (uint32_t)ceil(look_options.wobble_px + EDGE_PX) + 1;
}
