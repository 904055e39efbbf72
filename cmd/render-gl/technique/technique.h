/* A technique: a way to turn tone into strokes. It is one file technique/NAME.c, with more files technique/NAME_*.c and
 * a folder of shaders if it needs them, and one line in technique/list.h. The command's options, --help, --animate,
 * completions, and the refusal of options of other techniques follow from its members. HACKING.md explains how to add
 * one. */
#ifndef RENDER_TECHNIQUE_TECHNIQUE_H
#define RENDER_TECHNIQUE_TECHNIQUE_H

#include "render-gl/assets/asset.h"
#include "render-gl/frame/items.h"

#define SHADED_DEFINES_BYTES 256u

/* Features; bits. */
enum technique_feature {
    TECHNIQUE_STROKES = 1,     /* draws strokes along texture coordinates; feature lines are drawn by default */
    TECHNIQUE_PIXEL_LIGHT = 2, /* can compute light per pixel */
    TECHNIQUE_PIECES = 4,      /* can draw near faces as pieces, exact at any zoom */
    TECHNIQUE_NO_COLOR = 8,    /* its output is numbers, not a colour: no haloes are drawn over it */
    TECHNIQUE_REFERENCE = 16,  /* draws the tone without strokes: --time compares with it */
    TECHNIQUE_ALL_COLUMNS = 32 /* blends all columns of a map, coloured ones too */
};

/* An option that --animate and the window's keys can change. */
struct technique_param {
    const char *option; /* name of the option, without dashes; NULL ends a list */
    bool by_factor;     /* changes by factors; false: by differences */
    double step;        /* factor or difference per key press, in the option's unit */
};

/* Everything that a technique may use to read files, prepare and draw. */
struct technique_context {
    struct frame *frame;
    struct assets *assets;
    struct cmd_args *args;         /* arenas; for reading files */
    const struct hatch_view *view; /* of the first picture */
    double height_px;              /* of the first picture */
};

/* A technique in use. */
struct technique_instance {
    const struct technique *technique;
    void *state;                     /* state_size bytes, zeroed before `read` */
    const struct asset_tones *tones; /* of its asset; NULL: it has none, or is not prepared */
};

/* Functions may be NULL. */
struct technique {
    const char *name;
    const char *summary;                  /* one line, for the window's list of techniques */
    const struct cmd_option *options;     /* its own options, ended by one without a name; NULL: none */
    const struct technique_param *params; /* its options that may change from frame to frame; NULL: none */
    const struct asset_kind *asset;       /* kind of asset that it requires; NULL: none */
    uint32_t features;                    /* enum technique_feature, joined */
    uint32_t reach_px;                    /* distance beyond a tile's border that influences the tile */
    uint32_t samples;                     /* default of --samples, a square number; 0: that of the option */
    double tone_scale;                    /* factor for the darkest tone; 0: 1 */
    size_t state_size;                    /* of its state, in bytes; 0: a struct shaded_state */
    struct frame_shading shading;         /* of shaded_prepare and shaded_draw; zeroed: it draws otherwise */

    /* Fails with HATCH_BAD_INPUT if the scene lacks something that it draws.
     *   patches  one entry per mesh of the scene */
    enum hatch_status (*check)(const struct hatch_scene *scene, const struct hatch_patch_mesh *patches,
                               struct hatch_err *err);
    /* Reads the files that its options name. Exits with a message on failure. */
    void (*read)(struct technique_context *context, struct technique_instance *instance);
    /* Uploads and compiles what the posed scene needs, after its asset has been uploaded. Repeated calls return at
     * once. NULL: shaded_prepare. */
    enum hatch_status (*prepare)(struct technique_context *context, struct technique_instance *instance,
                                 struct hatch_err *err);
    /* Draws the scene into the canvas of the frame, between frame_begin and frame_end. NULL: shaded_draw. */
    enum hatch_status (*draw)(struct technique_context *context, struct technique_instance *instance,
                              struct hatch_err *err);
    /* Applies new values of its options. On failure the old state stays. */
    enum hatch_status (*changed)(struct technique_context *context, struct technique_instance *instance,
                                 struct hatch_err *err);
    /* Returns the darkest tone that it can draw, 0 .. 1; NULL: the asset's. */
    double (*darkest)(const struct technique_instance *instance);
    /* Releases what the state owns outside args->keep. */
    void (*free)(struct technique_instance *instance);
};

/* Makes an instance of a technique; its state is in args->keep. HATCH_LIMIT when memory does not suffice. */
enum hatch_status technique_open(struct technique_instance *instance, const struct technique *technique,
                                 struct cmd_args *args, struct hatch_err *err) HATCH_MUST_USE;

/* Uploads the technique's asset and prepares it to draw the scene. Repeated calls return at once. */
enum hatch_status technique_prepare(struct technique_context *context, struct technique_instance *instance,
                                    struct hatch_err *err) HATCH_MUST_USE;

/* Draws a tile of the posed scene into the request's canvas and averages the samples. */
enum hatch_status technique_draw(struct technique_context *context, struct technique_instance *instance,
                                 const struct frame_request *request, struct hatch_err *err) HATCH_MUST_USE;

/* Releases the instance; leaves *instance zeroed. */
void technique_close(struct technique_instance *instance);

/* Returns the distance beyond a tile's border that influences the tile, in pixels.
 *   line_px  as in struct frame_request */
uint32_t technique_reach_px(const struct technique_context *context, const struct technique_instance *instance,
                            double line_px);

/* The state of a technique that draws every item with one struct frame_shading, or the first member of its state. */
struct shaded_state {
    struct frame_shader shader;
    char defines[SHADED_DEFINES_BYTES]; /* lines with which the shader was compiled, beside the shading's */
};

/* Compiles the programs for the scene's items: prepare of such a technique. */
enum hatch_status shaded_prepare(struct technique_context *context, struct technique_instance *instance,
                                 struct hatch_err *err) HATCH_MUST_USE;

/* Does the same with additional definitions, which may differ from call to call.
 *   defines  lines before every stage */
enum hatch_status shaded_prepare_with(struct technique_context *context, struct technique_instance *instance,
                                      const char *defines, struct hatch_err *err) HATCH_MUST_USE;

/* Draws every item: draw of such a technique. */
enum hatch_status shaded_draw(struct technique_context *context, struct technique_instance *instance,
                              struct hatch_err *err) HATCH_MUST_USE;

#endif
