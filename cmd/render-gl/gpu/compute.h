/* Compute passes. */
#ifndef RENDER_GPU_COMPUTE_H
#define RENDER_GPU_COMPUTE_H

#include "render-gl/gpu/program.h"

/* Runs a compute program.
 *   groups   number of work groups along x, y, z; each at least 1
 *   barrier  later accesses that must see its writes, as in glMemoryBarrier (GL_TEXTURE_FETCH_BARRIER_BIT ...) */
void gpu_dispatch(const struct gpu_program *program, const GLuint groups[3], GLbitfield barrier);

/* Binds the finest level of a texture as an image that a compute program reads and writes.
 *   unit    IMAGE_... of gpu/bindings.h
 *   format  the texture's internal format */
void gpu_image_bind(GLuint unit, GLuint texture, GLenum format);

#endif
