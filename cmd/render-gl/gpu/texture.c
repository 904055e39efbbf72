#include "render-gl/gpu/texture.h"

GLuint gpu_texture_make(GLenum kind, GLsizei levels, GLenum format, uint32_t width, uint32_t height, uint32_t depth)
{
    GLuint texture;
    glCreateTextures(kind, 1, &texture);
    if (kind == GL_TEXTURE_2D)
        glTextureStorage2D(texture, levels, format, (GLsizei)width, (GLsizei)height);
    else
        glTextureStorage3D(texture, levels, format, (GLsizei)width, (GLsizei)height, (GLsizei)depth);
    return texture;
}

GLuint gpu_texture_2d(GLenum format, uint32_t width, uint32_t height)
{
    return gpu_texture_make(GL_TEXTURE_2D, 1, format, width, height, 1);
}

enum hatch_status gpu_check_texels(size_t texels, const char *what, struct hatch_err *err)
{
    GLint limit;
    glGetIntegerv(GL_MAX_TEXTURE_BUFFER_SIZE, &limit);
    if (texels <= (size_t)limit)
        return HATCH_OK;
    return hatch_fail(err, HATCH_LIMIT, "too many %s: %zu texels, the GPU's limit is %d", what, texels, limit);
}

GLuint gpu_texture_of_buffer(GLenum format, GLuint buffer)
{
    GLuint texture;
    glCreateTextures(GL_TEXTURE_BUFFER, 1, &texture);
    glTextureBuffer(texture, format, buffer);
    return texture;
}

void gpu_texture_read_grey(GLuint texture)
{
    static const GLint grey[4] = {GL_RED, GL_RED, GL_RED, GL_ONE};
    glTextureParameteriv(texture, GL_TEXTURE_SWIZZLE_RGBA, grey);
}

void gpu_texture_bind(GLuint unit, GLuint texture, GLuint sampler)
{
    glBindTextureUnit(unit, texture);
    glBindSampler(unit, sampler);
}

void gpu_image_bind(GLuint unit, GLuint texture, GLenum format)
{
    glBindImageTexture(unit, texture, 0, GL_FALSE, 0, GL_READ_WRITE, format);
}
