/* Looks of solid textures: plain, binary, watercolor and collage. A technique draws the items in a look (look_draw), or
 * watercolor paints the picture of any technique (look_paint): the amounts of ink in the picture become washes, and the
 * texture on the items varies the pigment. */
#ifndef RENDER_LOOK_LOOK_H
#define RENDER_LOOK_LOOK_H

#include "render-gl/assets/solid.h"
#include "render-gl/frame/items.h"

/* Values of --look. */
enum look_kind { LOOK_PLAIN, LOOK_BINARY, LOOK_WATERCOLOR, LOOK_COLLAGE };

#define LOOK_INKS_MAX 16u
#define LOOK_DEFINES_BYTES 128u

struct look_options {
    const char *files;  /* --solid */
    const char *inks;   /* --inks; NULL: not given */
    const char *turn;   /* --solid-turn; NULL: not given */
    int kind;           /* --look: enum look_kind */
    int blend;          /* --blend: enum hatch_zoom_blend; -1: as suits the look */
    double period_px;   /* --solid-size; 0: two pixels per texel */
    double grain;       /* --grain, 0 .. 1 */
    int64_t bands;      /* --bands */
    double wobble_px;   /* --wobble */
    double dry;         /* --dry, 0 .. 1 */
    double wet;         /* --wet, 0 .. 1 */
    double darkening;   /* --edge-darkening, 0 .. 1 */
    double paper_grain; /* --paper-grain, 0 .. 1 */
    double border_px;   /* --border */
    bool colors;        /* --texture-color */
};

extern struct look_options look_options;
extern const struct cmd_option look_option_table[];

/* The uniform block of the shaders (solid/zoom.glsl, solid/image.glsl). */
struct look_block {
    float zoom[4];  /* binary logarithm of the period, in units of the scene at distance 1; pixels along a period of
                       the paper behind the scene; binary logarithm of the period in pixels; how far ink runs */
    float marks[4]; /* grain; wobble in samples; share that a dry brush skips; darkening of edges */
    float edges[4]; /* number of tones; number of inks; grain of the paper; unused */
    float inks[LOOK_INKS_MAX][4]; /* R G B, linear */
    struct {
        float offset[4], axes[3][4]; /* struct solids */
    } colors[SOLIDS_MAX];
};

/* A look in use. */
struct look {
    enum look_kind kind;
    bool paints;                      /* it paints the pictures of a technique; false: it draws the items */
    struct frame_shading shading;     /* of the pass over the items */
    struct frame_shader shader;       /* likewise */
    struct frame_shader papers;       /* of a collage: of the pass that draws the papers on the items */
    char defines[LOOK_DEFINES_BYTES]; /* #define lines of the shader */
    struct solid_files files;
    struct solids solids;
    struct solids_form form; /* that solids were uploaded in */
    struct look_block block;
    GLuint block_buffer; /* 0: not made */
};

/* Reads the files of --solid and the colours of --inks. Exits with a message on failure.
 *   kind, paints  as in struct look
 *   look          in: zeroed
 * Returns the look. */
struct look *look_read(struct cmd_args *args, enum look_kind kind, bool paints, struct look *look);

/* Chooses how a look draws the items, once its files are known. */
void look_choose(struct look *look, enum look_kind kind);

/* Uploads and compiles everything that drawing the posed scene needs. Repeated calls do nothing.
 *   view, height_px  view and height of the first picture, for flat textures
 *   side             samples along a side of a pixel */
enum hatch_status look_prepare(struct look *look, struct frame *frame, const struct hatch_view *view, double height_px,
                               uint32_t side, struct cmd_args *args, struct hatch_err *err) HATCH_MUST_USE;

/* Draws the items of the scene into the canvas of the frame, between frame_begin and frame_end. Makes the textures anew
 * where --solid-size has changed.
 * HATCH_LIMIT when main memory or the GPU's memory does not suffice. */
enum hatch_status look_draw(struct look *look, struct frame *frame, struct cmd_args *args,
                            struct hatch_err *err) HATCH_MUST_USE;

/* Paints the canvas of the frame over as a watercolour, after a technique has drawn ink on paper there; else like
 * look_draw. */
enum hatch_status look_paint(struct look *look, struct frame *frame, struct cmd_args *args,
                             struct hatch_err *err) HATCH_MUST_USE;

/* Returns how far outside a tile drawing influences it, in pixels (look/passes.c). */
uint32_t look_reach_px(enum look_kind kind);

/* Releases everything that the look has made. */
void look_free(struct look *look);

/* Compiles the programs of a look's passes over the image (look/passes.c). */
enum hatch_status look_passes_prepare(struct look *look, struct frame *frame, struct hatch_err *err) HATCH_MUST_USE;

/* Draws the items and runs these passes, after the uniform block and the textures have been bound. */
enum hatch_status look_passes_draw(struct look *look, struct frame *frame, struct hatch_err *err) HATCH_MUST_USE;

#endif
