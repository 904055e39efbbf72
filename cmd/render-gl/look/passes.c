#include "render-gl/look/passes.h"

#include <assert.h>
#include <stdio.h>
#include <string.h>

#include "render-gl/gpu/bindings.h"
#include "render-gl/gpu/texture.h"

static enum hatch_status program_of(const struct look *look, struct frame *frame, const struct look_pass *pass,
                                    const struct gpu_program **program, struct hatch_err *err)
{
    const struct gpu_stages stages = {.vertex = "canvas/screen.vert", .fragment = pass->fragment};
    char defines[LOOK_DEFINES_BYTES];
    snprintf(defines, sizeof defines, "%s%s", look->paints ? "#define PICTURE 1\n" : "",
             look_options.colors ? "#define COLORS 1\n" : "");
    return gpu_program_get(&frame->programs, &stages, defines, program, err);
}

enum hatch_status look_passes_compile(const struct look *look, struct frame *frame, const struct look_pass *passes,
                                      uint32_t count, struct hatch_err *err)
{
    const struct gpu_program *program;
    for (uint32_t i = 0; i < count; i++)
        HATCH_TRY(program_of(look, frame, &passes[i], &program, err));
    return HATCH_OK;
}

enum hatch_status look_pass_target(struct look_drawing drawing, const struct look_pass *pass,
                                   const struct gpu_target **target, struct hatch_err *err)
{
    const struct canvas *canvas = drawing.frame->request.canvas;
    uint32_t side = pass->pixels ? canvas->side : 1;
    struct gpu_target_form form = {.width = canvas->samples.form.width / side,
                                   .height = canvas->samples.form.height / side};
    memcpy(form.outputs, pass->outputs, sizeof pass->outputs);
    return frame_target(&drawing.frame->targets, &form, target, err);
}

enum hatch_status look_pass_run(struct look_drawing drawing, const struct look_pass *pass,
                                const struct look_uniforms *uniforms, const struct gpu_target *target,
                                struct hatch_err *err)
{
    struct frame *frame = drawing.frame;
    const struct gpu_program *program;
    HATCH_TRY(program_of(drawing.look, frame, pass, &program, err));
    bool sets_depth = !target && !drawing.look->paints; /* a picture has its depth */
    const struct frame_pass screen = {.name = pass->name,
                                      .target = target ? target : &frame->request.canvas->samples,
                                      .depth = sets_depth ? FRAME_DEPTH_REPLACE : FRAME_DEPTH_NONE};
    assert(uniforms || !pass->uniforms);
    if (pass->uniforms & LOOK_ALONG)
        glProgramUniform2iv(program->name, UNIFORM_A, 1, uniforms->along);
    if (pass->uniforms & LOOK_RADIUS)
        glProgramUniform1f(program->name, UNIFORM_B, (float)uniforms->radius);
    if (pass->uniforms & LOOK_NUMBER)
        glProgramUniform1i(program->name, UNIFORM_C, uniforms->number);
    frame_pass_begin(&screen);
    frame_pass_screen(program);
    frame_pass_end(&screen, frame->timer);
    return HATCH_OK;
}

enum hatch_status look_pass_add(struct look_drawing drawing, const struct look_pass *pass,
                                const struct look_uniforms *uniforms, const struct gpu_target **target,
                                struct hatch_err *err)
{
    HATCH_TRY(look_pass_target(drawing, pass, target, err));
    return look_pass_run(drawing, pass, uniforms, *target, err);
}

enum hatch_status look_pass_both(struct look_drawing drawing, const struct look_pass *pass, GLuint from, double radius,
                                 const struct gpu_target **target, struct hatch_err *err)
{
    const struct look_uniforms down = {.along = {0, 1}, .radius = radius}, across = {.along = {1, 0}, .radius = radius};
    gpu_texture_bind(UNIT_SOURCE, from, 0);
    HATCH_TRY(look_pass_add(drawing, pass, &down, target, err));
    gpu_texture_bind(UNIT_SOURCE, (*target)->outputs[0], 0);
    return look_pass_add(drawing, pass, &across, target, err);
}

enum hatch_status look_draw_items(struct look_drawing drawing, const struct gpu_target_form *form,
                                  const struct frame_shading *shading, struct frame_shader *shader,
                                  const struct gpu_target **target, struct hatch_err *err)
{
    static const float far = 0;
    struct frame *frame = drawing.frame;
    HATCH_TRY(frame_target(&frame->targets, form, target, err));
    const struct frame_pass clear = {.name = "clear", .target = *target, .clear_depth = &far};
    frame_pass_begin(&clear);
    for (uint32_t i = 0; i < 3 && form->outputs[i]; i++)
        gpu_target_clear(*target, i, GL_RGBA, GL_FLOAT, NULL);
    frame_pass_end(&clear, frame->timer);
    return frame_draw_items(frame, *target, shading, drawing.look->defines, shader, err);
}

enum hatch_status look_passes_prepare(struct look *look, struct frame *frame, struct hatch_err *err)
{
    if (look->kind == LOOK_WATERCOLOR)
        return look_watercolor_prepare(look, frame, err);
    return look->kind == LOOK_COLLAGE ? look_collage_prepare(look, frame, err) : HATCH_OK;
}

enum hatch_status look_passes_draw(struct look *look, struct frame *frame, struct hatch_err *err)
{
    const struct look_drawing drawing = {look, frame};
    if (look->kind == LOOK_WATERCOLOR)
        return look_watercolor_draw(drawing, err);
    if (look->kind == LOOK_COLLAGE)
        return look_collage_draw(drawing, err);
    return frame_draw_items(frame, &frame->request.canvas->samples, &look->shading, look->defines, &look->shader, err);
}

uint32_t look_reach_px(enum look_kind kind)
{
    if (kind == LOOK_WATERCOLOR)
        return look_watercolor_reach_px();
    return kind == LOOK_COLLAGE ? look_collage_reach_px() : 0;
}
