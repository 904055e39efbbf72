/* Recursive procedural tonal art maps as the arrays that shaders read. */
#ifndef HATCH_SEED_PACK_H
#define HATCH_SEED_PACK_H

#include "seed/rptam.h"

#define HATCH_RPTAM_IMAGES_SHIFT 16 /* of at[3] below: the bits under it hold the number of seed points */

/* 80 bytes, std140. */
struct hatch_rptam_layer_block {
    float turn[4];   /* cosine, sine of the strokes' direction; square of the tile's side; ink */
    float tone[4];   /* amount = x way + y; where it begins; lists for smaller strokes */
    float stroke[4]; /* texels a pixel, along and across; its texels less one */
    int32_t at[4];   /* first list; texels of lists along a side; first texel of the stroke; its images */
    float thin[4];   /* least share of its length and width to which a stroke shrinks */
};

/* std140. */
struct hatch_rptam_block {
    float front[4];    /* 2 p (1 - p); where it is linear: from, factor, term */
    float fade[4];     /* weight = x front + y + z life (+ w in the next level) */
    float law[4];      /* 1: the front is m; 1: the share is 1 - m; 0; steps a unit of ink */
    int32_t counts[4]; /* layers */
    struct hatch_rptam_layer_block layers[HATCH_RPTAM_LAYERS_MAX];
};

/* Arrays in the arena that packed them. Lists are pairs of the first seed and of the one after the last; a seed is
 * there once for each list that it is in, so that one read finds it. */
struct hatch_rptam_packed {
    struct hatch_rptam_block block;
    uint32_t *seeds;                        /* 4 each: u and v as the bits of floats, lives, lives in the next level */
    int32_t *lists;                         /* 2 each */
    uint8_t *strokes;                       /* 4 a texel: alpha there, to the right, below, and both */
    uint16_t *numbers;                      /* of seeds in their set; NULL: all strokes of a layer look alike */
    float ways[2 * HATCH_RPTAM_TONE_STEPS]; /* way to a tone, and the rise to the next */
    struct hatch_rptam_lives *lives;        /* of one layer's seeds: 16 each, by the tile */
    size_t seed_count, list_count, stroke_count;
};

/* Packs a model.
 *   all  every list holds all strokes that may reach into the tile, which is slow to draw */
enum hatch_status hatch_rptam_pack(const struct hatch_rptam *rptam, bool all, struct hatch_arena *arena,
                                   struct hatch_rptam_packed *packed, struct hatch_err *err) HATCH_MUST_USE;

#endif
