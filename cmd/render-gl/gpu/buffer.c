#include "render-gl/gpu/buffer.h"

#include <stdarg.h>
#include <stdio.h>

#define MIN_BYTES 16u

GLuint gpu_buffer_make(const void *data, size_t size_bytes)
{
    GLuint buffer;
    glCreateBuffers(1, &buffer);
    glNamedBufferStorage(buffer, (GLsizeiptr)(size_bytes > MIN_BYTES ? size_bytes : MIN_BYTES), NULL,
                         GL_DYNAMIC_STORAGE_BIT);
    if (data)
        gpu_buffer_update(buffer, data, size_bytes);
    return buffer;
}

void gpu_buffer_update(GLuint buffer, const void *data, size_t size_bytes)
{
    /* Not glNamedBufferSubData: with NVIDIA's driver (580.159) the GPU keeps what a buffer was made with if it is
     * overwritten by that function before it is first read. */
    glBindBuffer(GL_ARRAY_BUFFER, buffer);
    glBufferSubData(GL_ARRAY_BUFFER, 0, (GLsizeiptr)size_bytes, data);
    glBindBuffer(GL_ARRAY_BUFFER, 0);
}

void gpu_block_update(GLuint *buffer, GLuint binding, const void *block, size_t size_bytes)
{
    if (!*buffer)
        *buffer = gpu_buffer_make(NULL, size_bytes);
    gpu_buffer_update(*buffer, block, size_bytes);
    glBindBufferBase(GL_UNIFORM_BUFFER, binding, *buffer);
}

void gpu_storage_bind(GLuint binding, GLuint buffer)
{
    glBindBufferBase(GL_SHADER_STORAGE_BUFFER, binding, buffer);
}

void gpu_buffer_read(GLuint buffer, void *data, size_t size_bytes)
{
    glGetNamedBufferSubData(buffer, 0, (GLsizeiptr)size_bytes, data);
}

void gpu_buffer_copy(GLuint from, size_t from_bytes, GLuint to, size_t to_bytes, size_t size_bytes)
{
    if (size_bytes)
        glCopyNamedBufferSubData(from, to, (GLintptr)from_bytes, (GLintptr)to_bytes, (GLsizeiptr)size_bytes);
}

void gpu_array_attach(GLuint array, GLuint slot, GLuint buffer, size_t stride_bytes,
                      const struct gpu_attribute *attributes, size_t count)
{
    glVertexArrayVertexBuffer(array, slot, buffer, 0, (GLsizei)stride_bytes);
    for (size_t i = 0; i < count; i++) {
        const struct gpu_attribute *attribute = &attributes[i];
        glEnableVertexArrayAttrib(array, attribute->location);
        if (attribute->type == GL_FLOAT)
            glVertexArrayAttribFormat(array, attribute->location, attribute->components, GL_FLOAT, GL_FALSE,
                                      attribute->offset_bytes);
        else
            glVertexArrayAttribIFormat(array, attribute->location, attribute->components, attribute->type,
                                       attribute->offset_bytes);
        glVertexArrayAttribBinding(array, attribute->location, slot);
    }
}

enum hatch_status gpu_check_memory(struct hatch_err *err, const char *what, ...)
{
    char text[200];
    va_list args;
    if (glGetError() != GL_OUT_OF_MEMORY)
        return HATCH_OK;
    va_start(args, what);
    vsnprintf(text, sizeof text, what, args);
    va_end(args);
    return hatch_fail(err, HATCH_LIMIT, "the GPU has no memory for %s", text);
}
