/* Textures of fixed size. */
#ifndef RENDER_GPU_TEXTURE_H
#define RENDER_GPU_TEXTURE_H

#include <epoxy/gl.h>
#include <stdint.h>

/* Makes an unset texture of one level. */
GLuint gpu_texture_2d(GLenum format, uint32_t width, uint32_t height);

/* Makes an unset texture of `levels` levels.
 *   kind   GL_TEXTURE_2D, _2D_ARRAY or _3D
 *   depth  layers or slices; of 2D textures 1 */
GLuint gpu_texture_make(GLenum kind, GLsizei levels, GLenum format, uint32_t width, uint32_t height, uint32_t depth);

/* Makes a texture that reads a buffer as an array of texels. */
GLuint gpu_texture_of_buffer(GLenum format, GLuint buffer);

/* A one-channel texture read as grey with alpha 1. */
void gpu_texture_read_grey(GLuint texture);

/* Binds a texture to a unit.
 *   sampler  0: the texture's own state */
void gpu_texture_bind(GLuint unit, GLuint texture, GLuint sampler);

#endif
