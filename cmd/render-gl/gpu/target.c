#include "render-gl/gpu/target.h"

#include "render-gl/gpu/buffer.h"
#include "render-gl/gpu/texture.h"

enum hatch_status gpu_target_make(const struct gpu_target_form *form, struct gpu_target *target, struct hatch_err *err)
{
    struct gpu_target made = {.form = *form};
    GLenum draws[GPU_OUTPUTS_MAX];
    glCreateFramebuffers(1, &made.framebuffer);
    for (uint32_t i = 0; i < GPU_OUTPUTS_MAX && form->outputs[i]; i++) {
        draws[i] = GL_COLOR_ATTACHMENT0 + i;
        made.outputs[i] = gpu_texture_2d(form->outputs[i], form->width, form->height);
        glNamedFramebufferTexture(made.framebuffer, draws[i], made.outputs[i], 0);
        made.output_count++;
    }
    glNamedFramebufferDrawBuffers(made.framebuffer, (GLsizei)made.output_count, draws);
    if (form->depth) {
        made.depth = gpu_texture_2d(form->depth, form->width, form->height);
        glNamedFramebufferTexture(made.framebuffer, GL_DEPTH_ATTACHMENT, made.depth, 0);
    }
    enum hatch_status status = gpu_check_memory(err, "a target of %u by %u texels", form->width, form->height);
    if (status == HATCH_OK &&
        glCheckNamedFramebufferStatus(made.framebuffer, GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE)
        status = hatch_fail(err, HATCH_LIMIT, "the GPU cannot draw into a target of %u by %u texels", form->width,
                            form->height);
    if (status == HATCH_OK)
        *target = made;
    else
        gpu_target_free(&made);
    return status;
}

void gpu_target_clear(const struct gpu_target *target, uint32_t output, GLenum layout, GLenum type, const void *texel)
{
    glClearTexImage(target->outputs[output], 0, layout, type, texel);
}

void gpu_target_read(const struct gpu_target *target, uint32_t output, struct gpu_rectangle from, GLenum layout,
                     GLenum type, uint32_t row_length, void *texels)
{
    glBindFramebuffer(GL_READ_FRAMEBUFFER, target->framebuffer);
    glReadBuffer(GL_COLOR_ATTACHMENT0 + output);
    glPixelStorei(GL_PACK_ROW_LENGTH, (GLint)row_length);
    glReadPixels((GLint)from.x, (GLint)from.y, (GLsizei)from.width, (GLsizei)from.height, layout, type, texels);
    glPixelStorei(GL_PACK_ROW_LENGTH, 0);
}

float gpu_target_read_depth(const struct gpu_target *target, uint32_t x, uint32_t y)
{
    float depth = 0;
    glBindFramebuffer(GL_READ_FRAMEBUFFER, target->framebuffer);
    glReadPixels((GLint)x, (GLint)y, 1, 1, GL_DEPTH_COMPONENT, GL_FLOAT, &depth);
    return depth;
}

void gpu_target_free(struct gpu_target *target)
{
    glDeleteFramebuffers(1, &target->framebuffer);
    glDeleteTextures((GLsizei)target->output_count, target->outputs);
    glDeleteTextures(1, &target->depth);
    *target = (struct gpu_target){.output_count = 0};
}
