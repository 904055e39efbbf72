/* Shaders: files of shaders/, built into the command or read from a folder. A line
 *     #include "name"
 * takes in another of them, once per stage. */
#ifndef RENDER_SHADER_H
#define RENDER_SHADER_H

#include <epoxy/gl.h>

#include "base/arena.h"

struct shader_stages {
    const char *vertex;   /* file names; "tam.vert" */
    const char *geometry; /* or NULL */
    const char *fragment;
};

/* Where shaders come from, and memory for joining them. */
struct shader_source {
    const char *folder; /* NULL: the built-in ones */
    struct hatch_arena *scratch;
};

/* Compiles and links. defines: lines put before every stage ("#define COLOR 1\n"), "" for none.
 * *program is the caller's to delete. HATCH_IO for a file of the folder that cannot be read,
 * HATCH_BAD_INPUT with the compiler's first complaint, which names the file and the line. */
enum hatch_status shader_program(const struct shader_source *source, const struct shader_stages *stages,
                                 const char *defines, GLuint *program, struct hatch_err *err) HATCH_MUST_USE;

#endif
