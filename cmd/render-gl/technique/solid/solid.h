/* The technique solid: its options and state. */
#ifndef RENDER_TECHNIQUE_SOLID_H
#define RENDER_TECHNIQUE_SOLID_H

#include "render-gl/assets/solid.h"
#include "render-gl/technique/technique.h"

/* Ways to draw the texture: --look. */
enum solid_look { SOLID_PLAIN, SOLID_BINARY, SOLID_WATERCOLOR, SOLID_COLLAGE };

#define SOLID_INKS_MAX 16u

struct solid_options {
    const char *files;  /* --solid */
    const char *inks;   /* --inks; NULL: not given */
    const char *turn;   /* --solid-turn; NULL: not given */
    int look;           /* enum solid_look */
    int blend;          /* enum hatch_zoom_blend */
    double period_px;   /* --solid-size; 0: two pixels per texel */
    double grain;       /* --grain, 0 .. 1 */
    int64_t bands;      /* --bands */
    double wobble_px;   /* --wobble */
    double dry;         /* --dry, 0 .. 1 */
    double darkening;   /* --edge-darkening, 0 .. 1 */
    double paper_grain; /* --paper-grain, 0 .. 1 */
    double border_px;   /* --border */
};

extern struct solid_options solid_options;
extern const struct cmd_option solid_option_table[];

/* The uniform block of the shaders (solid/zoom.glsl, solid/image.glsl). */
struct solid_block {
    float zoom[4];  /* binary logarithm of the period, in units of the scene at distance 1; pixels along a period of
                       the paper behind the scene; binary logarithm of the period in pixels */
    float marks[4]; /* grain; wobble in samples; share that a dry brush skips; darkening of edges */
    float edges[4]; /* number of tones; number of inks; grain of the paper; unused */
    float inks[SOLID_INKS_MAX][4]; /* R G B, linear */
    struct {
        float offset[4], axes[3][4]; /* struct solids */
    } colors[SOLIDS_MAX];
};

struct solid_state {
    struct shaded_state shaded; /* the pass that draws the items */
    struct frame_shading shading;
    struct solid_files files;
    struct solids solids;
    struct solids_form form; /* that solids were uploaded in */
    struct solid_block block;
    GLuint block_buffer; /* 0: not made */
};

/* Returns the pass in which a look draws the items.
 *   flat  the textures are flat: their places are texture coordinates */
struct frame_shading solid_look_shading(enum solid_look look, bool flat);

/* Compiles the programs of a look's passes over the image. */
enum hatch_status solid_look_prepare(struct frame *frame, enum solid_look look, struct hatch_err *err) HATCH_MUST_USE;

/* Draws the scene in a look, after the block and the textures have been bound. */
enum hatch_status solid_look_draw(struct frame *frame, enum solid_look look, struct shaded_state *shaded,
                                  const struct frame_shading *shading, struct hatch_err *err) HATCH_MUST_USE;

/* Returns how far outside a tile drawing influences it, in pixels. */
uint32_t solid_look_reach_px(enum solid_look look);

#endif
