/* A technique: how tone becomes strokes. One file technique/NAME.c, with more files technique/NAME_*.c and a folder of
 * shaders if it needs them, and one line in technique/list.h. What it says here feeds the command's options, --help,
 * --animate, completions, and the refusal of options that do not belong to it. HACKING.md walks through one. */
#ifndef RENDER_TECHNIQUE_TECHNIQUE_H
#define RENDER_TECHNIQUE_TECHNIQUE_H

#include "render-gl/assets/asset.h"
#include "render-gl/frame/items.h"

/* Features; bits. */
enum technique_feature {
    TECHNIQUE_STROKES = 1,     /* draws strokes along texture coordinates, not tone alone: feature lines belong to it */
    TECHNIQUE_PIXEL_LIGHT = 2, /* can compute light per pixel */
    TECHNIQUE_PIECES = 4,      /* draws near faces as pieces: true at any zoom */
    TECHNIQUE_NO_COLOR = 8,    /* its output is numbers: no haloes are drawn over it */
    TECHNIQUE_REFERENCE = 16,  /* the tone alone: --time compares with it */
    TECHNIQUE_ALL_COLUMNS = 32 /* blends all columns of a map, coloured ones too */
};

/* One of a technique's options as a parameter of --animate and of the window's keys. */
struct technique_param {
    const char *option; /* its name; the last has none */
    bool by_factor;     /* it changes by factors; else by differences */
    double step;        /* of a key: factor or difference, in the option's unit */
};

/* What techniques draw with. */
struct technique_context {
    struct frame *frame;
    struct assets *assets;
    struct cmd_args *args;         /* arenas; for reading files */
    const struct hatch_view *view; /* of the first picture, */
    double height_px;              /* and its height */
};

/* A technique in use. */
struct technique_instance {
    const struct technique *technique;
    void *state;                     /* its own, zeroed before `read` */
    const struct asset_tones *tones; /* of its asset; NULL: it has none, or is not prepared */
};

/* Every function may be NULL but draw. */
struct technique {
    const char *name;
    const char *summary;                  /* one line */
    const struct cmd_option *options;     /* its own, ended by one without a name; NULL: none */
    const struct technique_param *params; /* those of its options that may change from frame to frame; NULL: none */
    const struct asset_kind *asset;       /* NULL: it reads none */
    uint32_t features;                    /* enum technique_feature, joined */
    uint32_t reach_px;                    /* how far beyond a tile it looks */
    uint32_t samples;                     /* a pixel, by default; 0: as the command's option says */
    double tone_scale;                    /* factor for the darkness that is asked for; 0: 1 */
    size_t state_size;                    /* bytes */
    const struct frame_shading *shading;  /* of techniques that draw by shaded_draw (technique/shaded.h) */

    /* Fails with HATCH_BAD_INPUT where the scene lacks what it draws. patches: of each of the scene's meshes. */
    enum hatch_status (*check)(const struct hatch_scene *scene, const struct hatch_patch_mesh *patches,
                               struct hatch_err *err);
    /* Reads the files that its options name; dies with one line on what is wrong with them. */
    void (*read)(struct technique_context *context, struct technique_instance *instance);
    /* Uploads and compiles for the scene, which is posed; the asset is uploaded. Calling it again is cheap. */
    enum hatch_status (*prepare)(struct technique_context *context, struct technique_instance *instance,
                                 struct hatch_err *err);
    /* Draws the scene into the canvas of the frame, between frame_begin and frame_end. */
    enum hatch_status (*draw)(struct technique_context *context, struct technique_instance *instance,
                              struct hatch_err *err);
    /* Applies new values of its options; after a failure the old ones stay. */
    enum hatch_status (*changed)(struct technique_context *context, struct technique_instance *instance,
                                 struct hatch_err *err);
    /* The darkest tone that it can draw, 0 .. 1, where that is not the asset's. */
    double (*darkest)(const struct technique_instance *instance);
    /* Releases what the state holds on the GPU. */
    void (*free)(struct technique_instance *instance);
};

/* Gives a technique its state, in args->keep. HATCH_LIMIT when memory does not suffice. */
enum hatch_status technique_open(struct technique_instance *instance, const struct technique *technique,
                                 struct cmd_args *args, struct hatch_err *err) HATCH_MUST_USE;

/* Makes a technique ready to draw the scene. */
enum hatch_status technique_prepare(struct technique_context *context, struct technique_instance *instance,
                                    struct hatch_err *err) HATCH_MUST_USE;

/* Draws a tile of a frame into its canvas and averages the samples. The scene is posed. */
enum hatch_status technique_draw(struct technique_context *context, struct technique_instance *instance,
                                 const struct frame_request *request, struct hatch_err *err) HATCH_MUST_USE;

void technique_close(struct technique_instance *instance);

/* How far beyond a tile a technique and its frame look, in pixels. line_px: as in struct frame_request. */
uint32_t technique_reach_px(const struct technique_context *context, const struct technique_instance *instance,
                            double line_px);

#endif
