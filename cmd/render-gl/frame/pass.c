#include "render-gl/frame/pass.h"

#include "render-gl/gpu/bindings.h"

#define GROUPS_MOST 65535u /* work groups in a row that OpenGL guarantees */

static void enable(GLenum capability, bool enabled)
{
    if (enabled)
        glEnable(capability);
    else
        glDisable(capability);
}

static const struct {
    GLenum equation, color_from, color_to, alpha_from, alpha_to;
} blends[] = {[FRAME_BLEND_REPLACE] = {GL_FUNC_ADD, GL_ONE, GL_ZERO, GL_ONE, GL_ZERO},
              [FRAME_BLEND_OVER] = {GL_FUNC_ADD, GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE_MINUS_SRC_ALPHA},
              [FRAME_BLEND_OVER_COLOR] = {GL_FUNC_ADD, GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ZERO, GL_ONE},
              [FRAME_BLEND_ADD] = {GL_FUNC_ADD, GL_ONE, GL_ONE, GL_ONE, GL_ONE},
              [FRAME_BLEND_MAX] = {GL_MAX, GL_ONE, GL_ONE, GL_ONE, GL_ONE},
              [FRAME_BLEND_SET_ALPHA] = {GL_FUNC_ADD, GL_ZERO, GL_ONE, GL_ONE, GL_ZERO},
              [FRAME_BLEND_UNDER_ALPHA] = {GL_FUNC_ADD, GL_DST_ALPHA, GL_ONE_MINUS_DST_ALPHA, GL_ZERO, GL_ONE},
              [FRAME_BLEND_ADD_UNDER_ALPHA] = {GL_FUNC_ADD, GL_DST_ALPHA, GL_ONE, GL_ZERO, GL_ONE}};

void frame_pass_blend(enum frame_blend blend)
{
    enable(GL_BLEND, blend != FRAME_BLEND_REPLACE);
    glBlendEquation(blends[blend].equation);
    glBlendFuncSeparate(blends[blend].color_from, blends[blend].color_to, blends[blend].alpha_from,
                        blends[blend].alpha_to);
}

void frame_pass_blend_output(uint32_t output, enum frame_blend blend)
{
    if (blend == FRAME_BLEND_REPLACE)
        glDisablei(GL_BLEND, output);
    else
        glEnablei(GL_BLEND, output);
    glBlendEquationi(output, blends[blend].equation);
    glBlendFuncSeparatei(output, blends[blend].color_from, blends[blend].color_to, blends[blend].alpha_from,
                         blends[blend].alpha_to);
}

static void set_depth(enum frame_depth depth)
{
    static const GLenum ways[] = {GL_ALWAYS, GL_GREATER, GL_EQUAL, GL_GREATER, GL_LESS, GL_ALWAYS};
    enable(GL_DEPTH_TEST, depth != FRAME_DEPTH_NONE);
    glDepthFunc(ways[depth]);
    bool writes = depth == FRAME_DEPTH_NEARER || depth == FRAME_DEPTH_LOWER || depth == FRAME_DEPTH_REPLACE;
    glDepthMask(writes ? GL_TRUE : GL_FALSE);
}

void frame_pass_begin(const struct frame_pass *pass)
{
    const struct gpu_target *target = pass->target;
    const GLboolean colors = pass->masks_color ? GL_FALSE : GL_TRUE;
    glBindFramebuffer(GL_FRAMEBUFFER, target->framebuffer);
    glViewport(0, 0, (GLsizei)target->form.width, (GLsizei)target->form.height);
    glClipControl(GL_LOWER_LEFT, GL_ZERO_TO_ONE);
    glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    glDepthMask(GL_TRUE);
    if (pass->clear)
        glClearBufferfv(GL_COLOR, 0, pass->clear);
    if (pass->clear_depth)
        glClearBufferfv(GL_DEPTH, 0, pass->clear_depth);
    glColorMask(colors, colors, colors, colors);
    frame_pass_blend(pass->blend);
    set_depth(pass->depth);
    enable(GL_CULL_FACE, pass->culls);
    glCullFace(GL_BACK);
}

void frame_pass_screen(const struct gpu_program *program)
{
    glUseProgram(program->name);
    glBindVertexArray(program->no_attributes);
    glDrawArrays(GL_TRIANGLES, 0, 3);
}

void frame_pass_quads(const struct gpu_program *program, GLuint array, GLsizei instances)
{
    glUseProgram(program->name);
    glBindVertexArray(array ? array : program->no_attributes);
    glDrawArraysInstanced(GL_TRIANGLE_STRIP, 0, 4, instances);
}

void frame_pass_points(const struct gpu_program *program, GLuint array, GLsizei count)
{
    glUseProgram(program->name);
    glBindVertexArray(array);
    glDrawArrays(GL_POINTS, 0, count);
}

void frame_pass_end(const struct frame_pass *pass, struct gpu_timer *timer)
{
    gpu_timer_end_pass(timer, pass->name);
}

void frame_dispatch(const struct frame_dispatch *dispatch, struct gpu_timer *timer)
{
    glUseProgram(dispatch->program->name);
    glDispatchCompute(dispatch->groups[0], dispatch->groups[1], dispatch->groups[2]);
    glMemoryBarrier(dispatch->barrier);
    gpu_timer_end_pass(timer, dispatch->name);
}

void frame_dispatch_over(const struct frame_dispatch *dispatch, uint32_t count, struct gpu_timer *timer)
{
    struct frame_dispatch pass = *dispatch;
    GLint size[3];
    glGetProgramiv(pass.program->name, GL_COMPUTE_WORK_GROUP_SIZE, size);
    const uint32_t groups = count / (uint32_t)size[0] + 1, row = groups < GROUPS_MOST ? groups : GROUPS_MOST;
    pass.groups[0] = row;
    pass.groups[1] = (groups - 1) / row + 1;
    pass.groups[2] = 1;
    glProgramUniform1ui(pass.program->name, UNIFORM_COUNT, count);
    frame_dispatch(&pass, timer);
}
