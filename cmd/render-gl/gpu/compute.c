#include "render-gl/gpu/compute.h"

void gpu_dispatch(const struct gpu_program *program, const GLuint groups[3], GLbitfield barrier)
{
    glUseProgram(program->name);
    glDispatchCompute(groups[0], groups[1], groups[2]);
    glMemoryBarrier(barrier);
}

void gpu_image_bind(GLuint unit, GLuint texture, GLenum format)
{
    glBindImageTexture(unit, texture, 0, GL_FALSE, 0, GL_READ_WRITE, format);
}
