/* Textures of fixed size. */
#ifndef RENDER_GPU_TEXTURE_H
#define RENDER_GPU_TEXTURE_H

#include <epoxy/gl.h>
#include <stddef.h>
#include <stdint.h>

#include "base/status.h"

/* Makes a 2D texture of one level with undefined content.
 *   format  internal format */
GLuint gpu_texture_2d(GLenum format, uint32_t width, uint32_t height);

/* Makes a texture with undefined content.
 *   kind    GL_TEXTURE_2D, GL_TEXTURE_2D_ARRAY or GL_TEXTURE_3D
 *   levels  number of mip levels
 *   format  internal format
 *   depth   layers of an array or slices of a 3D texture; ignored for 2D */
GLuint gpu_texture_make(GLenum kind, GLsizei levels, GLenum format, uint32_t width, uint32_t height, uint32_t depth);

/* Fails with HATCH_LIMIT if a buffer has more texels than shaders can read through a texture: they would read zeros.
 *   what  what there are too many of */
enum hatch_status gpu_check_texels(size_t texels, const char *what, struct hatch_err *err) HATCH_MUST_USE;

/* Makes a texture through which shaders read a buffer as an array of texels.
 *   format  internal format of a texel, such as GL_RGBA8 */
GLuint gpu_texture_of_buffer(GLenum format, GLuint buffer);

/* Makes shaders read a one-channel texture as grey with alpha 1. */
void gpu_texture_read_grey(GLuint texture);

/* Binds a texture to a unit.
 *   unit     UNIT_... of gpu/bindings.h
 *   sampler  0: the texture's own filters */
void gpu_texture_bind(GLuint unit, GLuint texture, GLuint sampler);

/* Binds the finest level of a texture as an image that a compute program reads and writes.
 *   unit    IMAGE_... of gpu/bindings.h
 *   format  the texture's internal format */
void gpu_image_bind(GLuint unit, GLuint texture, GLenum format);

#endif
