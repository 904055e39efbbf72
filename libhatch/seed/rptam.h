/* Recursive procedural tonal art maps in double precision: what a renderer draws, and the measure of
 * it (Algorithm 2 with the extensions that §6 names: layers, fading by opacity or size, together or one
 * after the other, and lists of the strokes near a place). */
#ifndef HATCH_SEED_RPTAM_H
#define HATCH_SEED_RPTAM_H

#include "image/image.h"
#include "seed/coverage.h"
#include "seed/fade.h"

#define HATCH_RPTAM_SEEDS_MAX 1024u
#define HATCH_RPTAM_LAYERS_MAX 8u
#define HATCH_RPTAM_STEPS 17u /* of a layer's tone table */

struct hatch_rptam_style {
    double tile_px;   /* side of the seeds' tile at an integer depth, 1 / F of the paper: 8 .. 8192 */
    double length_px, width_px; /* of strokes, on the screen, over 0 */
    double angle_rad[HATCH_RPTAM_LAYERS_MAX]; /* of each layer's strokes to u */
    double ink;       /* how dark a stroke is, over 0 .. 1 */
    enum hatch_fade_law law;
    bool fade_size;   /* strokes shrink; else they pale */
    double overlap;   /* of fading with depth, 0 .. 1: hatch_fade_weight */
    double tone_overlap; /* of fading with tone, 0 .. 1 */
};

struct hatch_rptam_layer {
    uint32_t count;
    struct hatch_seed_place *places;
    uint8_t *stays_in;  /* per seed: which of four tiles shows it at the sparse level, 2 v + u */
    double *tone_rank;  /* per seed, 0 .. 1, among those that fade with tone: another order than with depth */
    struct hatch_coverage coverage;
    double cosine, sine;
    double rank_offset; /* 0 .. 1: strokes of different tiles and layers go at different depths */
    double darkness[HATCH_RPTAM_STEPS]; /* the mean that the layers up to this one give, at amounts
                                           0, 1/16 .. 1 of this one; rising */
};

struct hatch_rptam {
    struct hatch_rptam_style style;
    uint32_t layer_count;
    struct hatch_rptam_layer layers[HATCH_RPTAM_LAYERS_MAX];
    struct hatch_image stroke; /* one channel: alpha at two texels a pixel, and a border of nothing */
};

/* stroke: one channel, alpha 0 .. 1, x along and y across, of any size: it is brought to the size that is
 * drawn. Layers over HATCH_RPTAM_LAYERS_MAX, and larger sets than HATCH_RPTAM_SEEDS_MAX, are HATCH_LIMIT. */
enum hatch_status hatch_rptam_make(const struct hatch_seeds *seeds,
                                   const struct hatch_rptam_style *style,
                                   const struct hatch_image *stroke, struct hatch_arena *arena,
                                   struct hatch_arena *scratch, struct hatch_rptam *rptam,
                                   struct hatch_err *err) HATCH_MUST_USE;

/* How much of each layer, 0 .. 1, a darkness asks for: layers come one after the other. amounts:
 * layer_count entries. */
void hatch_rptam_amounts(const struct hatch_rptam *rptam, double darkness, double *amounts);

/* The share of ink that one layer puts at a place. uv: texture coordinates; depth: M of §5.1, any finite
 * number; amount: 0 .. 1. all: look at every seed, not only at the coverage's. */
double hatch_rptam_layer_ink(const struct hatch_rptam *rptam, uint32_t layer, const double uv[2],
                             double depth, double amount, bool all);

/* All layers at a place: each covers what shines through those before it. amounts: layer_count. */
double hatch_rptam_ink(const struct hatch_rptam *rptam, const double uv[2], double depth,
                       const double *amounts, bool all);

#endif
