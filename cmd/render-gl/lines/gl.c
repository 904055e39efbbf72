#include "render-gl/lines/gl.h"

#include <stddef.h>

#define RESULT_ROWS 1024u

enum { TEST, STROKE, OVER };

enum hatch_status line_gl_compile(const struct shader_source *shaders, struct line_gl *gl, struct hatch_err *err)
{
    static const struct shader_stages stages[LINE_PROGRAMS] = {
        [TEST] = {.vertex = "screen.vert", .fragment = "line_test.frag"},
        [STROKE] = {.vertex = "line_stroke.vert", .fragment = "line_stroke.frag"},
        [OVER] = {.vertex = "screen.vert", .fragment = "line_over.frag"}};
    for (int i = 0; i < LINE_PROGRAMS; i++) {
        GLuint fresh;
        HATCH_TRY(shader_program(shaders, &stages[i], gl->haloes ? "#define HALOES 1\n" : "", &fresh, err));
        glDeleteProgram(gl->programs[i]);
        gl->programs[i] = fresh;
    }
    return HATCH_OK;
}

static void make_texture(GLenum format, uint32_t width, uint32_t height, GLuint *texture, GLuint *framebuffer)
{
    glCreateTextures(GL_TEXTURE_2D, 1, texture);
    glTextureStorage2D(*texture, 1, format, (GLsizei)width, (GLsizei)height);
    glCreateFramebuffers(1, framebuffer);
    glNamedFramebufferTexture(*framebuffer, GL_COLOR_ATTACHMENT0, *texture, 0);
}

enum hatch_status line_gl_make(const struct shader_source *shaders, bool haloes, struct line_gl *gl,
                               struct hatch_err *err)
{
    struct line_gl made = {.haloes = haloes};
    enum hatch_status status = line_gl_compile(shaders, &made, err);
    if (status != HATCH_OK) {
        line_gl_free(&made);
        return status;
    }
    glCreateBuffers(1, &made.segments);
    glCreateVertexArrays(1, &made.array);
    glVertexArrayVertexBuffer(made.array, 0, made.segments, 0, sizeof(struct hatch_line_segment));
    for (GLuint i = 0; i < 2; i++) {
        glEnableVertexArrayAttrib(made.array, i);
        glVertexArrayAttribFormat(made.array, i, i ? 3 : 4, GL_FLOAT, GL_FALSE,
                                  i ? offsetof(struct hatch_line_segment, depth) : 0);
        glVertexArrayAttribBinding(made.array, i, 0);
    }
    glVertexArrayBindingDivisor(made.array, 0, 1);
    glCreateTextures(GL_TEXTURE_2D, 1, &made.samples);
    glTextureStorage2D(made.samples, 1, GL_RGBA32F, (GLsizei)LINE_BATCH, (GLsizei)RESULT_ROWS);
    make_texture(GL_R8UI, LINE_BATCH, RESULT_ROWS, &made.result, &made.result_framebuffer);
    *gl = made;
    return HATCH_OK;
}

/* Samples fill rows of the texture; the last may be shorter. */
static void upload(const struct line_gl *gl, const struct hatch_line_sample *samples, size_t count)
{
    GLsizei rows = (GLsizei)(count / LINE_BATCH), rest = (GLsizei)(count % LINE_BATCH);
    glPixelStorei(GL_UNPACK_ALIGNMENT, 4);
    if (rows)
        glTextureSubImage2D(gl->samples, 0, 0, 0, (GLsizei)LINE_BATCH, rows, GL_RGBA, GL_FLOAT, samples);
    if (rest)
        glTextureSubImage2D(gl->samples, 0, 0, rows, rest, 1, GL_RGBA, GL_FLOAT, samples + (size_t)rows * LINE_BATCH);
}

void line_gl_test(const struct line_gl *gl, const struct target *target, const struct hatch_line_sample *samples,
                  size_t count, uint8_t *seen)
{
    glBindFramebuffer(GL_FRAMEBUFFER, gl->result_framebuffer);
    glDisable(GL_DEPTH_TEST);
    glDisable(GL_BLEND);
    glUseProgram(gl->programs[TEST]);
    glBindTextureUnit(0, target->depth);
    glBindTextureUnit(1, gl->samples);
    glBindSampler(0, 0);
    glBindSampler(1, 0);
    glUniform1f(0, (GLfloat)target->side);
    glBindVertexArray(target->no_vertices);
    glPixelStorei(GL_PACK_ALIGNMENT, 4);
    const size_t most = (size_t)LINE_BATCH * RESULT_ROWS;
    for (size_t done = 0; done < count; done += most) {
        size_t batch = count - done < most ? count - done : most;
        GLsizei rows = (GLsizei)((batch + LINE_BATCH - 1) / LINE_BATCH);
        upload(gl, samples + done, batch);
        glViewport(0, 0, (GLsizei)LINE_BATCH, rows);
        glDrawArrays(GL_TRIANGLES, 0, 3);
        glReadPixels(0, 0, (GLsizei)LINE_BATCH, rows, GL_RED_INTEGER, GL_UNSIGNED_BYTE, seen + done);
    }
}

enum hatch_status line_gl_begin(struct line_gl *gl, const struct target *target, struct hatch_err *err)
{
    if (gl->width != target->width || gl->height != target->height) {
        glDeleteTextures(1, &gl->coverage);
        glDeleteFramebuffers(1, &gl->coverage_framebuffer);
        gl->width = target->width;
        gl->height = target->height;
        make_texture(GL_R16F, gl->width, gl->height, &gl->coverage, &gl->coverage_framebuffer);
        if (glGetError() == GL_OUT_OF_MEMORY)
            return hatch_fail(err, HATCH_LIMIT, "the GPU has no memory for lines");
    }
    const GLfloat none = 0.0f;
    glClearTexImage(gl->coverage, 0, GL_RED, GL_FLOAT, &none);
    return HATCH_OK;
}

void line_gl_stroke(const struct line_gl *gl, const struct hatch_line_segment *segments, size_t count, double width_px)
{
    glBindFramebuffer(GL_FRAMEBUFFER, gl->coverage_framebuffer);
    glViewport(0, 0, (GLsizei)gl->width, (GLsizei)gl->height);
    glDisable(GL_DEPTH_TEST);
    glDisable(GL_CULL_FACE);
    glEnable(GL_BLEND);
    glBlendEquation(GL_MAX);
    glUseProgram(gl->programs[STROKE]);
    glUniform2f(0, (GLfloat)gl->width, (GLfloat)gl->height);
    glUniform1f(1, (GLfloat)width_px);
    glBindVertexArray(gl->array);
    glNamedBufferData(gl->segments, (GLsizeiptr)(sizeof *segments * count), segments, GL_STREAM_DRAW);
    glDrawArraysInstanced(GL_TRIANGLE_STRIP, 0, 4, (GLsizei)count);
    glBlendEquation(GL_FUNC_ADD);
    glDisable(GL_BLEND);
}

void line_gl_end(const struct line_gl *gl, const struct target *target, const float rgb[3])
{
    glBindFramebuffer(GL_FRAMEBUFFER, target->resolved_framebuffer);
    glViewport(0, 0, (GLsizei)target->width, (GLsizei)target->height);
    glDisable(GL_DEPTH_TEST);
    glDisable(GL_CULL_FACE);
    glEnable(GL_BLEND);
    glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
    glUseProgram(gl->programs[OVER]);
    glUniform3fv(0, 1, rgb);
    glBindTextureUnit(0, gl->coverage);
    glBindSampler(0, 0);
    glBindVertexArray(target->no_vertices);
    glDrawArrays(GL_TRIANGLES, 0, 3);
    glDisable(GL_BLEND);
}

void line_gl_free(struct line_gl *gl)
{
    for (int i = 0; i < LINE_PROGRAMS; i++)
        glDeleteProgram(gl->programs[i]);
    glDeleteVertexArrays(1, &gl->array);
    glDeleteBuffers(1, &gl->segments);
    glDeleteTextures(1, &gl->samples);
    glDeleteTextures(1, &gl->result);
    glDeleteTextures(1, &gl->coverage);
    glDeleteFramebuffers(1, &gl->result_framebuffer);
    glDeleteFramebuffers(1, &gl->coverage_framebuffer);
    *gl = (struct line_gl){.width = 0};
}
