#include "render-gl/halo.h"

#include <math.h>

#define CELLS_MOST 12.0 /* of a halo's width: more would take longer and show nothing */
#define DEPTH 0.015     /* jumps of more have haloes, of twice as much whole ones: in halves of the picture's height */

enum { CELLS, BLOCKS, HALOES };

/* std140; the same as in shaders/halo.glsl */
struct halo_block {
    float sizes[4]; /* in samples: the reach, a cell's side, a pixel's side; 0 */
    float depth[4]; /* a jump's share of half the picture's height, by difference and by ratio; the least */
};

enum hatch_status halo_compile(const struct shader_source *shaders, struct halo *halo, struct hatch_err *err)
{
    static const struct shader_stages stages[HALO_PROGRAMS] = {
        [CELLS] = {.vertex = "screen.vert", .fragment = "halo_cells.frag"},
        [BLOCKS] = {.vertex = "screen.vert", .fragment = "halo_blocks.frag"},
        [HALOES] = {.vertex = "halo.vert", .fragment = "halo.frag"}};
    for (int i = 0; i < HALO_PROGRAMS; i++) {
        GLuint fresh;
        HATCH_TRY(shader_program(shaders, &stages[i], "#define HALOES 1\n", &fresh, err));
        glDeleteProgram(halo->programs[i]);
        halo->programs[i] = fresh;
    }
    return HATCH_OK;
}

static uint32_t parts(uint32_t whole, uint32_t part)
{
    return (whole + part - 1) / part;
}

static void make_texture(GLenum format, uint32_t width, uint32_t height, GLuint *texture, GLuint framebuffer)
{
    glDeleteTextures(1, texture);
    glCreateTextures(GL_TEXTURE_2D, 1, texture);
    glTextureStorage2D(*texture, 1, format, (GLsizei)width, (GLsizei)height);
    glNamedFramebufferTexture(framebuffer, GL_COLOR_ATTACHMENT0, *texture, 0);
}

static enum hatch_status make_room(struct halo *halo, const struct target *target, uint32_t cell, struct hatch_err *err)
{
    uint32_t width = parts(target->side * target->width, cell);
    uint32_t height = parts(target->side * target->height, cell);
    halo->cell = cell;
    if (halo->width == width && halo->height == height)
        return HATCH_OK;
    if (!halo->buffer) {
        glCreateFramebuffers(HALO_PROGRAMS, halo->framebuffers);
        glCreateBuffers(1, &halo->buffer);
        glNamedBufferStorage(halo->buffer, sizeof(struct halo_block), NULL, GL_DYNAMIC_STORAGE_BIT);
    }
    make_texture(GL_RGBA32F, width, height, &halo->cells, halo->framebuffers[CELLS]);
    make_texture(GL_R32F, parts(width, HALO_BLOCK), parts(height, HALO_BLOCK), &halo->blocks,
                 halo->framebuffers[BLOCKS]);
    halo->width = width;
    halo->height = height;
    return glGetError() == GL_OUT_OF_MEMORY ? hatch_fail(err, HATCH_LIMIT, "the GPU has no memory for haloes")
                                            : HATCH_OK;
}

static void set_state(const struct halo *halo, int program)
{
    glBindFramebuffer(GL_FRAMEBUFFER, halo->framebuffers[program]);
    glDisable(GL_DEPTH_TEST);
    glDisable(GL_CULL_FACE);
    glDisable(GL_BLEND);
    glUseProgram(halo->programs[program]);
}

static void reduce(const struct halo *halo, int program, uint32_t width, uint32_t height, GLuint none)
{
    set_state(halo, program);
    glViewport(0, 0, (GLsizei)width, (GLsizei)height);
    glBindVertexArray(none);
    glDrawArrays(GL_TRIANGLES, 0, 3);
}

static void use_texture(GLuint unit, GLuint texture)
{
    glBindTextureUnit(unit, texture);
    glBindSampler(unit, 0);
}

enum hatch_status halo_find(struct halo *halo, const struct target *target, const struct hatch_view *view,
                            double reach_px, struct hatch_err *err)
{
    double reach = reach_px * target->side, half = 1 / view->half_height;
    HATCH_TRY(make_room(halo, target, (uint32_t)fmax(target->side, ceil(reach / CELLS_MOST)), err));
    const struct halo_block block = {.sizes = {(float)reach, (float)halo->cell, (float)target->side, 0},
                                     .depth = {view->orthographic ? (float)(half * (view->far - view->near)) : 0.0f,
                                               view->orthographic ? 0.0f : (float)half, (float)DEPTH, 0}};
    glNamedBufferSubData(halo->buffer, 0, sizeof block, &block);
    glBindBufferBase(GL_UNIFORM_BUFFER, HALO_BINDING, halo->buffer);
    use_texture(HALO_UNIT_DEPTHS, target->depth);
    reduce(halo, CELLS, halo->width, halo->height, target->no_vertices);
    use_texture(HALO_UNIT_CELLS, halo->cells);
    reduce(halo, BLOCKS, parts(halo->width, HALO_BLOCK), parts(halo->height, HALO_BLOCK), target->no_vertices);
    use_texture(HALO_UNIT_BLOCKS, halo->blocks);
    return HATCH_OK;
}

void halo_draw(const struct halo *halo, const struct target *target, const float rgb[3])
{
    uint32_t blocks = parts(halo->width, HALO_BLOCK) * parts(halo->height, HALO_BLOCK);
    glNamedFramebufferTexture(halo->framebuffers[HALOES], GL_COLOR_ATTACHMENT0, target->color, 0);
    set_state(halo, HALOES);
    glViewport(0, 0, (GLsizei)(target->side * target->width), (GLsizei)(target->side * target->height));
    glEnable(GL_BLEND);
    glBlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ZERO, GL_ONE);
    glUniform3fv(0, 1, rgb);
    glBindVertexArray(target->no_vertices);
    glDrawArraysInstanced(GL_TRIANGLE_STRIP, 0, 4, (GLsizei)blocks);
    glDisable(GL_BLEND);
}

void halo_free(struct halo *halo)
{
    for (int i = 0; i < HALO_PROGRAMS; i++)
        glDeleteProgram(halo->programs[i]);
    if (halo->buffer)
        glDeleteFramebuffers(HALO_PROGRAMS, halo->framebuffers);
    glDeleteTextures(1, &halo->cells);
    glDeleteTextures(1, &halo->blocks);
    glDeleteBuffers(1, &halo->buffer);
    *halo = (struct halo){.cell = 0};
}
