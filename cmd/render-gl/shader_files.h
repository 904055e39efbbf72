/* The files of shaders/, as embed.sh builds them into the command. */
#ifndef RENDER_SHADER_FILES_H
#define RENDER_SHADER_FILES_H

struct shader_file {
    const char *name; /* "tam.frag" */
    const char *text; /* zero-terminated */
};

/* The last entry has no name. */
extern const struct shader_file shader_files[];

#endif
