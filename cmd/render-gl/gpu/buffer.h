/* GL buffers, and vertex arrays that read from them. */
#ifndef RENDER_GPU_BUFFER_H
#define RENDER_GPU_BUFFER_H

#include <epoxy/gl.h>
#include <stddef.h>

#include "base/status.h"

/* Makes a buffer of fixed size, which gpu_buffer_update may change later.
 *   data        size_bytes bytes, copied; NULL: the content is undefined
 *   size_bytes  0 is allowed */
GLuint gpu_buffer_make(const void *data, size_t size_bytes);

/* Overwrites the first size_bytes of a buffer. */
void gpu_buffer_update(GLuint buffer, const void *data, size_t size_bytes);

/* Writes a uniform block and binds it.
 *   buffer   in, out: 0 on the first call, which makes the buffer; the caller deletes it
 *   binding  BLOCK_... of gpu/bindings.h
 *   block    size_bytes bytes in std140 layout; the size must be the same in all calls */
void gpu_block_update(GLuint *buffer, GLuint binding, const void *block, size_t size_bytes);

/* Binds a buffer that compute stages read or write.
 *   binding  STORAGE_... of gpu/bindings.h */
void gpu_storage_bind(GLuint binding, GLuint buffer);

/* Reads back the first size_bytes of a buffer. Waits for the GPU. */
void gpu_buffer_read(GLuint buffer, void *data, size_t size_bytes);

/* Copies size_bytes from one buffer to another, from and to an offset in bytes. */
void gpu_buffer_copy(GLuint from, size_t from_bytes, GLuint to, size_t to_bytes, size_t size_bytes);

/* One vertex attribute and its position in the buffer. */
struct gpu_attribute {
    GLuint location;     /* ATTRIBUTE_... of gpu/bindings.h */
    GLint components;    /* 1 .. 4 */
    GLenum type;         /* GL_FLOAT, or GL_UNSIGNED_INT, which shaders read as integers */
    GLuint offset_bytes; /* from the start of a vertex */
};

/* Connects attributes of a vertex array to a buffer.
 *   slot          buffer binding point of the array; each buffer of one array needs a different slot
 *   stride_bytes  from one vertex to the next
 *   attributes    count entries */
void gpu_array_attach(GLuint array, GLuint slot, GLuint buffer, size_t stride_bytes,
                      const struct gpu_attribute *attributes, size_t count);

/* Fails with HATCH_LIMIT and "the GPU has no memory for WHAT" if an allocation has failed since the last check.
 *   what  printf format of WHAT */
enum hatch_status gpu_check_memory(struct hatch_err *err, const char *what, ...) HATCH_MUST_USE HATCH_PRINTF(2, 3);

#endif
