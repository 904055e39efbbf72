/* The files of shaders/ and the numbers of gpu/bindings.h, as gpu/embed.sh builds them into the command. */
#ifndef RENDER_GPU_SHADER_FILES_H
#define RENDER_GPU_SHADER_FILES_H

struct shader_file {
    const char *name; /* path in shaders/: "frame/light.glsl" */
    const char *text; /* zero-terminated */
};

/* Ended by an entry whose name is NULL. */
extern const struct shader_file shader_files[];

/* The #define lines of gpu/bindings.h; zero-terminated. */
extern const char shader_bindings[];

#endif
