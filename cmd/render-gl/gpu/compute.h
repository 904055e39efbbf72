/* Compute passes. */
#ifndef RENDER_GPU_COMPUTE_H
#define RENDER_GPU_COMPUTE_H

#include "render-gl/gpu/program.h"

/* Runs a compute program.
 *   groups   work groups along each axis, at least 1
 *   barrier  kinds of reads that wait for its writes: GL_TEXTURE_FETCH_BARRIER_BIT, GL_SHADER_STORAGE_BARRIER_BIT ...
 */
void gpu_dispatch(const struct gpu_program *program, const GLuint groups[3], GLbitfield barrier);

/* Binds the finest level of a texture as an image that a compute program reads and writes. */
void gpu_image_bind(GLuint unit, GLuint texture, GLenum format);

#endif
