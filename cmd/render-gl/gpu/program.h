/* Shader programs. Their sources are the files of shaders/, built into the command or read from a folder. Each
 * combination of stages and definitions is compiled once. A line #include "frame/light.glsl" inserts another file, at
 * most once per stage. Every stage begins with the #define lines of gpu/bindings.h. */
#ifndef RENDER_GPU_PROGRAM_H
#define RENDER_GPU_PROGRAM_H

#include <epoxy/gl.h>

#include "base/arena.h"

/* File names of a program's stages, relative to shaders/: either compute alone, or vertex and fragment with an optional
 * geometry stage. */
struct gpu_stages {
    const char *vertex, *geometry, *fragment, *compute; /* NULL: no such stage; string literals, kept by reference */
};

/* A compiled program. Pointers to it stay valid when it is compiled again. */
struct gpu_program {
    GLuint name;              /* name of the GL program */
    GLuint no_attributes;     /* empty vertex array, for draws without attributes: core profiles require a bound one */
    struct gpu_stages stages; /* stages and defines are the key by which gpu_program_get finds it */
    const char *defines;
    GLuint fresh;             /* during gpu_programs_reload: the new GL program; else 0 */
    struct gpu_program *next; /* NULL: the last */
};

struct gpu_programs {
    const char *folder;          /* folder of the shader files; NULL: the built-in ones are used */
    struct hatch_arena *scratch; /* for the text of a stage; kept by reference */
    struct hatch_arena keep;     /* holds the programs; the owner initialises it with a limit */
    struct gpu_program *first;   /* list of all programs; NULL: none */
    GLuint no_attributes;        /* shared by all programs; 0 until the first is made */
};

/* Supplies a program; compiles and links it on the first call.
 *   defines  lines put before every stage ("#define COLOR 1\n"), "" for none; copied
 *   program  out: owned by programs, valid until gpu_programs_free
 * HATCH_IO if a file of the folder cannot be read, HATCH_BAD_INPUT with the compiler's first message, which gives file
 * and line. */
enum hatch_status gpu_program_get(struct gpu_programs *programs, const struct gpu_stages *stages, const char *defines,
                                  const struct gpu_program **program, struct hatch_err *err) HATCH_MUST_USE;

/* Compiles all programs again, after files of the folder have changed. On failure all programs stay as they were. */
enum hatch_status gpu_programs_reload(struct gpu_programs *programs, struct hatch_err *err) HATCH_MUST_USE;

/* Deletes all programs; frees keep. */
void gpu_programs_free(struct gpu_programs *programs);

#endif
