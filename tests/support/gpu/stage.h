/* Compute stages made of built-in shader files and the test's own text. */
#ifndef HATCH_TEST_GPU_STAGE_H
#define HATCH_TEST_GPU_STAGE_H

#include "render-gl/gpu/program.h"
#include <string.h>

#include "render-gl/gpu/shader_files.h"
#include "run.h"

/* Returns the text of a shader file. */
static inline const char *shader_text(const char *name)
{
    const struct shader_file *file = shader_files;
    while (file->name && strcmp(file->name, name) != 0)
        file++;
    ck_assert_ptr_nonnull(file->name);
    return file->text;
}

/* Compiles and links a compute stage.
 *   texts  count of them, joined in their order */
static inline GLuint compute_program(GLsizei count, const char *const *texts)
{
    GLint linked = GL_FALSE;
    GLuint shader = glCreateShader(GL_COMPUTE_SHADER), program = glCreateProgram();
    glShaderSource(shader, count, texts, NULL);
    glCompileShader(shader);
    glAttachShader(program, shader);
    glLinkProgram(program);
    glDeleteShader(shader);
    glGetProgramiv(program, GL_LINK_STATUS, &linked);
    ck_assert_int_eq(linked, GL_TRUE);
    return program;
}

#endif
