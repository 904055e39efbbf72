/* Strokes at seed points: the technique's options, its model, its state. For its own files and for measurements. */
#ifndef RENDER_TECHNIQUE_RPTAM_H
#define RENDER_TECHNIQUE_RPTAM_H

#include "placement/style.h"
#include "render-gl/assets/seeds.h"
#include "render-gl/technique/shaded.h"
#include "seed/layers.h"

/* Values of its options, in their units. 0 where the drawing style decides; that is then filled in. */
struct rptam_options {
    const char *seeds;        /* file of the sets; NULL: sets are made */
    const char *layers;       /* file of layers that differ; NULL: none */
    const char *style;        /* the drawing style: brush, ink, directions, width and length where none is given */
    double stroke_px[2];      /* length, width; 0: unset */
    double ink;               /* 0: unset */
    double turn_deg, tile_px; /* tile_px 0: chosen to suit the strokes */
    int64_t layers_max;       /* no more sets than these are drawn */
    int fade;                 /* enum hatch_fade_law */
    int fade_by, loop;        /* 1: by size; 1: every seed at every place */
    double overlap;
    bool tile_given;
};

extern struct rptam_options rptam_options;
extern const struct cmd_option rptam_option_table[];

/* A stroke's image. */
struct rptam_stroke {
    struct hatch_image alpha, grain; /* grain: without pixels where there is none */
    bool varied;
};

/* What the model is made from. */
struct rptam_source {
    struct hatch_seeds sets;
    struct hatch_style drawing;
    struct rptam_stroke stroke;         /* the drawing style's */
    struct hatch_layers layers;         /* those that differ; count 0: none */
    struct rptam_stroke *layer_strokes; /* of each of them that has its own */
    struct hatch_arena arenas[2];       /* the model lies in one; the next is made in the other */
    int arena;
};

struct rptam_state {
    struct shaded_state shaded;
    struct rptam_source source;
    struct hatch_rptam own;          /* the model that the options describe */
    const struct hatch_rptam *model; /* what is drawn: own, or a caller's; NULL: not read yet */
    struct seeds seeds;              /* it on the GPU */
};

/* Reads the seeds, the layers and the drawing style that the options name, and makes the model; dies with one line on
 * what is wrong. */
void rptam_read(struct technique_context *context, struct technique_instance *instance);

/* Makes the model from what has been read and the options' values; the old one stays on failure. */
enum hatch_status rptam_make_model(struct cmd_args *args, struct rptam_state *state,
                                   struct hatch_err *err) HATCH_MUST_USE;

/* For measurements: coordinates among the seed points instead of colour. Its instance has a struct rptam_state. */
extern const struct technique technique_rptam_places;

#endif
