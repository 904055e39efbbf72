/* Buffers, and the vertex arrays that read them. */
#ifndef RENDER_GPU_BUFFER_H
#define RENDER_GPU_BUFFER_H

#include <epoxy/gl.h>
#include <stddef.h>

#include "base/status.h"

/* Makes a buffer of fixed size. size_bytes may be 0: drivers refuse empty buffers, so it gets a few bytes.
 *   data  NULL: unset; gpu_buffer_update may change it either way */
GLuint gpu_buffer_make(const void *data, size_t size_bytes);

/* Writes the first size_bytes of a buffer. */
void gpu_buffer_update(GLuint buffer, const void *data, size_t size_bytes);

/* Writes a uniform block and binds it; makes *buffer on the first call, when it is 0. */
void gpu_block_update(GLuint *buffer, GLuint binding, const void *block, size_t size_bytes);

/* Reads the first size_bytes of a buffer back; waits for the GPU. */
void gpu_buffer_read(GLuint buffer, void *data, size_t size_bytes);

/* Where an attribute of a vertex array lies in its buffer. */
struct gpu_attribute {
    GLuint location;
    GLint components;
    GLenum type; /* GL_FLOAT, or GL_UNSIGNED_INT, which shaders read as whole numbers */
    GLuint offset_bytes;
};

/* Lets a vertex array read attributes from a buffer.
 *   slot  the array's slot for this buffer: one of its own for each buffer of the array */
void gpu_array_attach(GLuint array, GLuint slot, GLuint buffer, size_t stride_bytes,
                      const struct gpu_attribute *attributes, size_t count);

/* HATCH_LIMIT with "the GPU has no memory for WHAT" where an allocation has failed since the last check. */
enum hatch_status gpu_check_memory(struct hatch_err *err, const char *what, ...) HATCH_MUST_USE HATCH_PRINTF(2, 3);

#endif
