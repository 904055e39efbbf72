/* Shader programs: files of shaders/, built into the command or read from a folder, compiled once for each set of
 * stages and definitions. A line #include "frame/light.glsl" takes in another of them, once per stage. Before each
 * stage stand the numbers of gpu/bindings.h. */
#ifndef RENDER_GPU_PROGRAM_H
#define RENDER_GPU_PROGRAM_H

#include <epoxy/gl.h>

#include "base/arena.h"

/* Names of files; a compute program has that stage alone, others a vertex and a fragment stage, and maybe geometry. */
struct gpu_stages {
    const char *vertex, *geometry, *fragment, *compute; /* NULL: none; string literals: kept by reference */
};

/* A compiled program. It keeps its place when it is compiled anew. */
struct gpu_program {
    GLuint name;
    GLuint no_attributes; /* a vertex array without any: core profiles want one bound for every draw */
    struct gpu_stages stages;
    const char *defines;
    struct gpu_program *next;
};

struct gpu_programs {
    const char *folder;          /* of the shaders; NULL: the built-in ones */
    struct hatch_arena *scratch; /* for joining their texts */
    struct hatch_arena keep;     /* the programs, initialised with a limit by the owner */
    struct gpu_program *first;
    GLuint no_attributes;
};

/* Finds a program, or compiles and links it.
 *   defines  lines put before every stage ("#define COLOR 1\n"), "" for none
 *   program  out: owned by programs, valid until gpu_programs_free
 * HATCH_IO for a file of the folder that cannot be read, HATCH_BAD_INPUT with the compiler's first complaint, which
 * names the file and the line. */
enum hatch_status gpu_program_get(struct gpu_programs *programs, const struct gpu_stages *stages, const char *defines,
                                  const struct gpu_program **program, struct hatch_err *err) HATCH_MUST_USE;

/* Compiles all programs anew, for shaders of a folder that have been edited. After an error all old ones stay. */
enum hatch_status gpu_programs_reload(struct gpu_programs *programs, struct hatch_err *err) HATCH_MUST_USE;

/* Deletes all programs; frees keep. */
void gpu_programs_free(struct gpu_programs *programs);

#endif
