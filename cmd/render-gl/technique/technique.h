/* A technique: a way to turn tone into strokes. It consists of a file technique/NAME.c, if needed more files
 * technique/NAME_*.c or a folder of them and a folder of shaders, and a line in technique/list.h. The command's
 * options, --help, --animate and completions, and the refusal of options of other techniques, follow from the members
 * of struct technique. HACKING.md explains how to add one. */
#ifndef RENDER_TECHNIQUE_TECHNIQUE_H
#define RENDER_TECHNIQUE_TECHNIQUE_H

#include "curve/line_brush.h"
#include "render-gl/assets/asset.h"
#include "render-gl/look/look.h"
#include "vector/curves.h"
#include "vector/paths.h"

#define SHADED_DEFINES_BYTES 256u
#define TECHNIQUE_AHEAD 2u /* frames of a film that are foreseen after one before it is drawn */

/* Features of a technique; bits. */
enum technique_feature {
    TECHNIQUE_STROKES = 1,      /* draws strokes along texture coordinates; feature lines are drawn by default */
    TECHNIQUE_PIXEL_LIGHT = 2,  /* can compute light per pixel */
    TECHNIQUE_NO_COLOR = 4,     /* writes numbers instead of colours: no haloes are drawn over them */
    TECHNIQUE_REFERENCE = 8,    /* draws the tone without strokes: --time compares with it */
    TECHNIQUE_ALL_COLUMNS = 16, /* blends all columns of a map, coloured ones too */
    TECHNIQUE_LINES = 32,       /* feature lines are drawn by default, though its strokes need no texture coordinates */
    TECHNIQUE_LOOKS = 64,       /* draws every look itself; --look watercolor paints the pictures of others */
    TECHNIQUE_TRACED = 128      /* draws strokes that are in the scene; meshes without them stay blank */
};

/* An option that --animate and the window's keys can change. */
struct technique_param {
    const char *option; /* name of the option, without dashes; NULL ends a list */
    bool by_factor;     /* true: a step multiplies the value; false: it is added or subtracted */
    double step;        /* factor or difference per key press; a difference is in the option's unit */
};

/* Everything that a technique may use to read files, prepare and draw. */
struct technique_context {
    struct frame *frame;
    struct assets *assets;
    struct cmd_args *args;         /* arenas, and the means to read files */
    const struct hatch_view *view; /* view of the first picture */
    double height_px;              /* height of the first picture */
    uint32_t side;                 /* samples along a side of its pixels */
    struct look *look;             /* that paints the pictures of techniques without looks of their own; NULL: none */
};

/* A technique in use. */
struct technique_instance {
    const struct technique *technique;
    void *state;                     /* state_size bytes, zeroed before `read` */
    const struct asset_tones *tones; /* its uploaded asset; NULL: it has none, or is not prepared */
    enum hatch_near_places places;   /* that of the technique, unless its functions `read` or `prepare` change it */
    const char *texcoords_for;       /* who needs texture coordinates, and what to do without them, for a message; NULL:
                                        surfaces need none; strokes need them, and `read` may change it */
};

/* The strokes of a frame as curves, for drawings by a pen. */
struct technique_curves {
    uint32_t layer_counts[2];             /* layers of the curves of each ink, one for each direction of strokes: those
                                             of the second ink begin at HATCH_CURVE_FAMILIES_MAX */
    double shortest_px;                   /* shorter visible parts are left out */
    struct hatch_vector_curves curves;    /* with widths and faces */
    struct hatch_vector_pen pen;          /* that draws them; its width is in pixels */
    struct hatch_vector_paths paths;      /* or what a pen draws of them in the picture; then curves.count is 0 */
    const struct hatch_stroke_look *look; /* for the colours of strokes, by HATCH_STROKE_NUMBER_BITS of their ids */
};

/* Strokes that a technique has found in its frames. */
struct technique_counts {
    uint64_t strokes, fragments; /* fragments: pixels of the strokes */
    uint64_t waited;             /* strokes that found no slot of their own at first */
};

/* A description of a technique. Any function may be NULL. */
struct technique {
    const char *name;
    const char *summary;                  /* one line, for the window's list of techniques */
    const struct cmd_option *options;     /* its own options, ended by one without a name; NULL: none */
    const struct cmd_option *shared;      /* options of another technique that it has, too; NULL: none */
    const struct technique_param *params; /* its options that may change from frame to frame; NULL: none */
    const char *pen_option;               /* its option whose place the pen of a drawing takes; NULL: none */
    const struct asset_kind *asset;       /* kind of asset that it requires; NULL: none */
    const struct asset_kind *extra;       /* kind of asset that it reads if there is one; NULL: none, or `asset` */
    uint32_t features;                    /* bits of enum technique_feature */
    enum hatch_near_places places;        /* how faces near the eye are drawn as pieces, precise at any zoom; or NONE */
    uint32_t samples;                     /* its default for --samples, a square number; 0: the option's default */
    double tone_scale;                    /* factor for the darkest tone; 0 counts as 1 */
    size_t state_size;                    /* size of its state in bytes; 0: the state is a struct shaded_state */
    struct frame_shading shading;         /* for shaded_prepare and shaded_draw; zeroed if it uses neither */

    /* Fails with HATCH_BAD_INPUT if the scene lacks something that it draws.
     *   patches  one entry per mesh of the scene */
    enum hatch_status (*check)(const struct hatch_scene *scene, const struct hatch_patch_mesh *patches,
                               struct hatch_err *err);
    /* Reads the files that its options name. Exits with a message on failure. */
    void (*read)(struct technique_context *context, struct technique_instance *instance);
    /* Uploads and compiles everything that drawing the posed scene needs, after the asset has been uploaded. Repeated
     * calls do nothing. NULL: shaded_prepare. */
    enum hatch_status (*prepare)(struct technique_context *context, struct technique_instance *instance,
                                 struct hatch_err *err);
    /* Draws the scene into the canvas of the frame, between frame_begin and frame_end. NULL: shaded_draw. */
    enum hatch_status (*draw)(struct technique_context *context, struct technique_instance *instance,
                              struct hatch_err *err);
    /* Finds in a frame of a film what frames before it depend on, after frame_begin; nothing is drawn. A frame is drawn
     * when it and TECHNIQUE_AHEAD frames after it have been foreseen. NULL: frames do not depend on others.
     *   pen_px  as in `curves`; 0: for `draw` */
    enum hatch_status (*foresee)(struct technique_context *context, struct technique_instance *instance, double pen_px,
                                 struct hatch_err *err);
    /* Counts the strokes of the frames that it has drawn since the last call: those of a picture. NULL: it cannot. */
    struct technique_counts (*count)(struct technique_instance *instance);
    /* Finds the strokes of the posed scene as curves, between frame_begin and frame_end. NULL: it has none.
     *   pen_px  width of the pen that will draw them
     *   arena   for the curves */
    enum hatch_status (*curves)(struct technique_context *context, struct technique_instance *instance, double pen_px,
                                struct hatch_arena *arena, struct technique_curves *curves, struct hatch_err *err);
    /* Returns the brush that draws feature lines over its pictures. NULL: lines have one width. */
    struct hatch_line_brush (*line_brush)(const struct technique_instance *instance);
    /* Applies new values of its options. On failure the old state stays in use. */
    enum hatch_status (*changed)(struct technique_context *context, struct technique_instance *instance,
                                 struct hatch_err *err);
    /* Returns how far outside a tile drawing influences it, in pixels; NULL: 0. */
    uint32_t (*reach_px)(const struct technique_instance *instance);
    /* Returns the darkest tone that it can draw, 0 .. 1; NULL: the asset's. */
    double (*darkest)(const struct technique_instance *instance);
    /* Releases what the state owns outside args->keep. */
    void (*free)(struct technique_instance *instance);
};

/* Returns whether an option is one of a technique. */
bool technique_has_option(const struct technique *technique, const char *name);

/* Returns whether the pen of a drawing takes the place of an option of a technique. */
bool technique_has_pen_for(const struct technique *technique, const char *name);

/* Returns whether a look may paint its pictures: they are ink on paper, and no look draws them. */
bool technique_is_painted(const struct technique *technique);

/* Returns the kind of asset that a technique reads, whether it requires it or not; NULL: none. */
const struct asset_kind *technique_asset(const struct technique *technique);

/* Makes an instance of a technique; its state is in args->keep. HATCH_LIMIT when memory does not suffice. */
enum hatch_status technique_open(struct technique_instance *instance, const struct technique *technique,
                                 struct cmd_args *args, struct hatch_err *err) HATCH_MUST_USE;

/* Uploads the asset of a technique and prepares the technique to draw the scene. Repeated calls do nothing. */
enum hatch_status technique_prepare(struct technique_context *context, struct technique_instance *instance,
                                    struct hatch_err *err) HATCH_MUST_USE;

/* Draws a tile of the posed scene into the request's canvas and averages the samples. */
enum hatch_status technique_draw(struct technique_context *context, struct technique_instance *instance,
                                 const struct frame_request *request, struct hatch_err *err) HATCH_MUST_USE;

/* Finds what a tile of the posed scene, of a frame of a film, has that frames before it depend on.
 *   request  as that with which the frame will be drawn
 *   pen_px   width of the pen that will draw its curves; 0: it will be a picture */
enum hatch_status technique_foresee(struct technique_context *context, struct technique_instance *instance,
                                    const struct frame_request *request, double pen_px,
                                    struct hatch_err *err) HATCH_MUST_USE;

/* Finds the strokes of the posed scene as curves.
 *   request  its tile is the whole picture; its canvas may be smaller
 *   pen_px   width of the pen that will draw them
 *   arena    for the curves */
enum hatch_status technique_find_curves(struct technique_context *context, struct technique_instance *instance,
                                        const struct frame_request *request, double pen_px, struct hatch_arena *arena,
                                        struct technique_curves *curves, struct hatch_err *err) HATCH_MUST_USE;

/* Returns the brush that draws feature lines over the pictures of a technique; zeroed: lines have one width. */
struct hatch_line_brush technique_line_brush(const struct technique_instance *instance);

/* Releases the instance; leaves *instance zeroed. */
void technique_close(struct technique_instance *instance);

/* Returns how far outside a tile drawing influences it, in pixels.
 *   line_px  as in struct frame_request */
uint32_t technique_reach_px(const struct technique_context *context, const struct technique_instance *instance,
                            double line_px);

/* The state, or the first member of the state, of a technique that draws every item with one struct frame_shading. */
struct shaded_state {
    struct frame_shader shader;
    char defines[SHADED_DEFINES_BYTES]; /* #define lines for the shader, in addition to those of the shading */
};

/* Compiles the programs for the scene's items: the function `prepare` of such a technique. */
enum hatch_status shaded_prepare(struct technique_context *context, struct technique_instance *instance,
                                 struct hatch_err *err) HATCH_MUST_USE;

/* Does the same with additional definitions, which may differ from call to call.
 *   defines  #define lines put before every stage */
enum hatch_status shaded_prepare_with(struct technique_context *context, struct technique_instance *instance,
                                      const char *defines, struct hatch_err *err) HATCH_MUST_USE;

/* Draws every item: the function `draw` of such a technique. */
enum hatch_status shaded_draw(struct technique_context *context, struct technique_instance *instance,
                              struct hatch_err *err) HATCH_MUST_USE;

#endif
