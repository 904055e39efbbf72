/* The files of shaders/ and the numbers of gpu/bindings.h, as embed.sh builds them into the command. */
#ifndef RENDER_GPU_SHADER_FILES_H
#define RENDER_GPU_SHADER_FILES_H

struct shader_file {
    const char *name; /* "frame/light.glsl" */
    const char *text; /* zero-terminated */
};

/* The last entry has no name. */
extern const struct shader_file shader_files[];

/* #define lines; zero-terminated. */
extern const char shader_bindings[];

#endif
