/* The technique rptam (recursive procedural tonal art maps: strokes at nested seed points): its options, model and
 * state. Included by the technique's own files and by tests/support/render_frame.h. */
#ifndef RENDER_TECHNIQUE_RPTAM_H
#define RENDER_TECHNIQUE_RPTAM_H

#include "placement/style.h"
#include "render-gl/assets/seeds.h"
#include "render-gl/technique/technique.h"
#include "seed/layers.h"

/* Values of the technique's options. Where "0: the style's" is noted, rptam_make_model replaces 0 by the value of the
 * drawing style. */
struct rptam_options {
    const char *seeds;   /* --seeds: file of seed sets; NULL: sets are made */
    const char *layers;  /* --layers: file of layers; NULL: none */
    const char *style;   /* --style: name or file of the drawing style */
    double stroke_px[2]; /* --stroke: length and width; 0: the style's */
    double ink;          /* --stroke-ink, 0.01 .. 1; 0: the style's */
    double turn_deg;     /* --stroke-turn: rotation of each stroke about its middle */
    double tile_px;      /* --seed-tile: side of the tile at a nesting level, chosen unless tile_given is set */
    int64_t layers_max;  /* --seed-layers: greatest number of seed sets drawn */
    int fade;            /* --fade: enum hatch_fade_law */
    int fade_by;         /* --fade-by: 0: opacity, 1: size */
    int loop;            /* --seed-loop: 0: coverage lists, 1: all strokes are tested everywhere */
    double overlap;      /* --overlap, 0 .. 1 */
    bool tile_given;     /* --seed-tile was given */
};

extern struct rptam_options rptam_options;
extern const struct cmd_option rptam_option_table[];

/* The image of a stroke. */
struct rptam_stroke {
    struct hatch_image alpha; /* one channel */
    struct hatch_image grain; /* one channel; pixels NULL: no grain */
    bool varied;              /* strokes differ at random: some are mirrored, and their grain is shifted */
};

/* The data from which the model is made. */
struct rptam_source {
    struct hatch_seeds sets;            /* one seed set per layer, or more */
    struct hatch_style drawing;         /* the drawing style */
    struct rptam_stroke stroke;         /* the stroke of the drawing style */
    struct hatch_layers layers;         /* lines of the file of layers; layers.count == 0: no file */
    struct rptam_stroke *layer_strokes; /* one per line, set only for lines that name a stroke; NULL: no file */
    struct hatch_arena arenas[2];       /* one holds the current model; the next model is made in the other */
    int arena;                          /* index of the arena that holds the current model */
};

struct rptam_state {
    struct shaded_state shaded;
    struct rptam_source source;
    struct hatch_rptam own;          /* the model that the options describe */
    const struct hatch_rptam *model; /* the model to draw: own, or one that a caller has set; NULL: not read yet */
    struct seeds seeds;              /* the model on the GPU */
};

/* Reads the files that the options name, and makes the model. This is the member read of technique_rptam. Exits with a
 * message on failure. */
void rptam_read(struct technique_context *context, struct technique_instance *instance);

/* Returns the mean ink of a stroke in its rectangle.
 *   grain  NULL, or without pixels: the stroke has none */
double rptam_mean_ink(const struct hatch_image *alpha, const struct hatch_image *grain);

/* The members prepare, changed, darkest and free of technique_rptam, for techniques whose state begins with a struct
 * rptam_state. */
enum hatch_status rptam_prepare(struct technique_context *context, struct technique_instance *instance,
                                struct hatch_err *err) HATCH_MUST_USE;
enum hatch_status rptam_changed(struct technique_context *context, struct technique_instance *instance,
                                struct hatch_err *err) HATCH_MUST_USE;
double rptam_darkest(const struct technique_instance *instance);
void rptam_free(struct technique_instance *instance);

/* Makes the model from the source and the options' values. On failure the old model stays in use. */
enum hatch_status rptam_make_model(struct cmd_args *args, struct rptam_state *state,
                                   struct hatch_err *err) HATCH_MUST_USE;

/* A technique for tests and measurements: writes each fragment's coordinates in the pattern of seed points instead of a
 * colour (shaders/rptam/places.frag). Its state is a struct rptam_state. */
extern const struct technique technique_rptam_places;

#endif
