/* Objects of OpenGL that nobody has deleted. */
#ifndef HATCH_TEST_GPU_ALIVE_H
#define HATCH_TEST_GPU_ALIVE_H

#include "render-gl/gpu/program.h"
#include "run.h"

/* Returns whether a program is left; drivers may keep a deleted one for some time, as its state tells. */
static inline bool is_program_alive(GLuint name)
{
    GLint deleted = GL_FALSE;
    if (glIsProgram(name))
        glGetProgramiv(name, GL_DELETE_STATUS, &deleted);
    return glIsProgram(name) && !deleted;
}

/* Fails if the current context holds an object. Names are small: those of deleted objects are given again. */
static inline void check_none_alive(void)
{
    for (GLuint name = 1; name <= 4096; name++) {
        ck_assert_msg(!glIsBuffer(name), "buffer %u is left", name);
        ck_assert_msg(!glIsTexture(name), "texture %u is left", name);
        ck_assert_msg(!glIsSampler(name), "sampler %u is left", name);
        ck_assert_msg(!glIsFramebuffer(name), "framebuffer %u is left", name);
        ck_assert_msg(!glIsVertexArray(name), "vertex array %u is left", name);
        ck_assert_msg(!is_program_alive(name), "program %u is left", name);
    }
}

#endif
