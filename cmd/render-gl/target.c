#include "render-gl/target.h"

#include <assert.h>
#include <stdio.h>

static enum hatch_status make_buffers(struct target *target, struct hatch_err *err)
{
    GLsizei width = (GLsizei)target->width, height = (GLsizei)target->height;
    GLsizei side = (GLsizei)target->side;
    glCreateTextures(GL_TEXTURE_2D, 1, &target->color);
    glTextureStorage2D(target->color, 1, GL_RGBA16F, side * width, side * height);
    glTextureParameteri(target->color, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
    glCreateTextures(GL_TEXTURE_2D, 1, &target->depth);
    glTextureStorage2D(target->depth, 1, GL_DEPTH_COMPONENT32F, side * width, side * height);
    glCreateFramebuffers(1, &target->framebuffer);
    glNamedFramebufferTexture(target->framebuffer, GL_COLOR_ATTACHMENT0, target->color, 0);
    glNamedFramebufferTexture(target->framebuffer, GL_DEPTH_ATTACHMENT, target->depth, 0);
    target->resolved = target->color;
    target->resolved_framebuffer = target->framebuffer;
    if (side > 1) {
        glCreateTextures(GL_TEXTURE_2D, 1, &target->resolved);
        glTextureStorage2D(target->resolved, 1, GL_RGBA16F, width, height);
        glCreateFramebuffers(1, &target->resolved_framebuffer);
        glNamedFramebufferTexture(target->resolved_framebuffer, GL_COLOR_ATTACHMENT0, target->resolved, 0);
    }
    if (glGetError() == GL_OUT_OF_MEMORY ||
        glCheckNamedFramebufferStatus(target->framebuffer, GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE)
        return hatch_fail(err, HATCH_LIMIT, "the GPU has no memory for a picture of %u by %u samples",
                          target->side * target->width, target->side * target->height);
    return HATCH_OK;
}

enum hatch_status target_make(uint32_t width, uint32_t height, uint32_t side, const struct shader_source *shaders,
                              struct target *target, struct hatch_err *err)
{
    static const struct shader_stages average = {.vertex = "screen.vert", .fragment = "average.frag"};
    static const struct shader_stages present = {.vertex = "screen.vert", .fragment = "present.frag"};
    struct target made = {.width = width, .height = height, .side = side};
    char defines[32];
    snprintf(defines, sizeof defines, "#define SIDE %u\n", side);
    enum hatch_status status = shader_program(shaders, &average, defines, &made.average, err);
    if (status == HATCH_OK)
        status = shader_program(shaders, &present, "", &made.present, err);
    glCreateVertexArrays(1, &made.no_vertices);
    if (status == HATCH_OK)
        status = make_buffers(&made, err);
    if (status == HATCH_OK)
        *target = made;
    else
        target_free(&made);
    return status;
}

void target_begin(const struct target *target, const float rgb[3])
{
    const GLfloat clear[4] = {rgb[0], rgb[1], rgb[2], 0.0f}, far = 0.0f;
    glBindFramebuffer(GL_FRAMEBUFFER, target->framebuffer);
    glViewport(0, 0, (GLsizei)(target->side * target->width), (GLsizei)(target->side * target->height));
    glClipControl(GL_LOWER_LEFT, GL_ZERO_TO_ONE);
    glEnable(GL_DEPTH_TEST);
    glDepthFunc(GL_GREATER);
    glDepthMask(GL_TRUE);
    glDisable(GL_BLEND);
    glClearBufferfv(GL_COLOR, 0, clear);
    glClearBufferfv(GL_DEPTH, 0, &far);
}

static void draw_screen(const struct target *target, GLuint program, GLuint from, GLuint framebuffer)
{
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
    glViewport(0, 0, (GLsizei)target->width, (GLsizei)target->height);
    glDisable(GL_DEPTH_TEST);
    glDisable(GL_CULL_FACE);
    glDisable(GL_BLEND);
    glUseProgram(program);
    glBindTextureUnit(0, from);
    glBindSampler(0, 0);
    glBindVertexArray(target->no_vertices);
    glDrawArrays(GL_TRIANGLES, 0, 3);
}

void target_resolve(const struct target *target)
{
    if (target->side > 1)
        draw_screen(target, target->average, target->color, target->resolved_framebuffer);
}

void target_present(const struct target *target)
{
    draw_screen(target, target->present, target->resolved, 0);
}

void target_read(const struct target *target, uint32_t left, uint32_t below, uint32_t width, uint32_t height,
                 struct hatch_image *image, uint32_t x, uint32_t y)
{
    assert(image->channel_count == 3 && x + width <= image->width && y + height <= image->height);
    glBindFramebuffer(GL_READ_FRAMEBUFFER, target->resolved_framebuffer);
    float *corner = image->pixels + 3 * ((size_t)(image->height - y - height) * image->width + x);
    glPixelStorei(GL_PACK_ALIGNMENT, 4);
    glPixelStorei(GL_PACK_ROW_LENGTH, (GLint)image->width);
    glReadPixels((GLint)left, (GLint)below, (GLsizei)width, (GLsizei)height, GL_RGB, GL_FLOAT, corner);
    glPixelStorei(GL_PACK_ROW_LENGTH, 0);
    /* OpenGL's first row is the lowest. */
    for (size_t low = 0, high = height - 1; low < high; low++, high--)
        for (size_t i = 0; i < 3 * (size_t)width; i++) {
            float *a = corner + 3 * low * image->width + i, *b = corner + 3 * high * image->width + i;
            float swap = *a;
            *a = *b;
            *b = swap;
        }
}

void target_read_samples(const struct target *target, float *rgba)
{
    glBindFramebuffer(GL_READ_FRAMEBUFFER, target->framebuffer);
    glPixelStorei(GL_PACK_ALIGNMENT, 4);
    glReadPixels(0, 0, (GLsizei)(target->side * target->width), (GLsizei)(target->side * target->height), GL_RGBA,
                 GL_FLOAT, rgba);
}

float target_middle_depth(const struct target *target)
{
    float depth = 0;
    glBindFramebuffer(GL_READ_FRAMEBUFFER, target->framebuffer);
    glReadPixels((GLint)(target->side * target->width / 2), (GLint)(target->side * target->height / 2), 1, 1,
                 GL_DEPTH_COMPONENT, GL_FLOAT, &depth);
    return depth;
}

void target_free(struct target *target)
{
    if (target->resolved != target->color) {
        glDeleteFramebuffers(1, &target->resolved_framebuffer);
        glDeleteTextures(1, &target->resolved);
    }
    glDeleteFramebuffers(1, &target->framebuffer);
    glDeleteTextures(1, &target->depth);
    glDeleteTextures(1, &target->color);
    glDeleteVertexArrays(1, &target->no_vertices);
    glDeleteProgram(target->average);
    glDeleteProgram(target->present);
    *target = (struct target){0};
}
