/* Solid textures on the GPU, as the infinite zoom reads them (solid/zoom.h). */
#ifndef RENDER_ASSETS_SOLID_H
#define RENDER_ASSETS_SOLID_H

#include <epoxy/gl.h>

#include "shared/cmd.h"
#include "solid/zoom.h"

#define SOLIDS_MAX 8u

/* The files of solid textures. */
struct solid_files {
    uint32_t count; /* 0: none */
    bool flat;      /* they are flat textures: KTX2 files of 2D textures, or pictures */
    bool isotropic; /* all of them are known to have no direction */
    struct hatch_solid solids[SOLIDS_MAX];
};

/* Solid textures as shaders read them. Zeroed: none. */
struct solids {
    uint32_t count;
    GLuint octaves[SOLIDS_MAX]; /* texture A of each; 0: not made */
    GLuint tables;              /* array texture of the tables of all, a layer per channel; 0: not made */
    uint32_t channels;          /* 1, or 3 if one of them has colour */
    uint32_t size;              /* texels along a side of A, of the largest */
    struct {
        float offset[4];  /* struct hatch_zoom; w: mean luminance of the texture */
        float axes[3][4]; /* w: binary logarithm of the texels along a side of A; standard deviation and mean of its
                             first value */
    } colors[SOLIDS_MAX];
};

/* Reads the files of a list.
 *   paths  names, separated by commas; "-" is standard input; a name without dot or slash that no file has is that of
 *          an installed style, whose texture is made
 *
 * Exits with a message on failure, and where some are flat and some are not. */
void solid_files_read(struct cmd_args *args, const char *paths, struct solid_files *files);

/* How solid textures are prepared for drawing. */
struct solids_form {
    double period_px; /* period of the texture on the screen at the beginning of a zoom cycle, pixels */
    double samples;   /* along a side of a pixel */
    bool grey;        /* their luminance alone is used */
    bool pairs;       /* those of one channel are array textures, whose layers hold a slice and the next one: shaders
                         read half as many texels; not interpolated between levels */
    enum hatch_zoom_blend blend;
};

/* Makes and uploads the textures.
 *   solids  out; unchanged on failure
 * HATCH_LIMIT when main memory or the GPU's memory does not suffice. */
enum hatch_status solids_upload(const struct solid_files *files, const struct solids_form *form,
                                struct hatch_pool *pool, struct hatch_arena *scratch, struct solids *solids,
                                struct hatch_err *err) HATCH_MUST_USE;

/* Binds the textures for shaders. */
void solids_use(const struct solids *solids);

/* Releases the textures; leaves *solids zeroed. */
void solids_free(struct solids *solids);

#endif
