/* Recursive procedural tonal art maps as uniform blocks and arrays for shaders. */
#ifndef HATCH_SEED_PACK_H
#define HATCH_SEED_PACK_H

#include "seed/rptam.h"

/* Position of the number of images in at[3] below; the lower bits hold the number of seed points. */
#define HATCH_RPTAM_IMAGES_SHIFT 16

#define HATCH_RPTAM_CRUMBS 8u

/* A layer, std140, 80 bytes. */
struct hatch_rptam_layer_block {
    float turn[4];   /* x, y: cosine and sine of the strokes' direction; z: tile_px²; w: ink */
    float tone[4];   /* x, y: amount = x * progress + y; z: progress at which the layer begins; w: number of coverage
                        sizes after the first */
    float stroke[4]; /* x, y: texels per pixel, along and across; z, w: texels of one image minus 1, along and across */
    int32_t at[4];   /* x: first list; y: lists along the tile's side; z: first texel of the stroke's images; w: for a
                        varied layer, number of images << HATCH_RPTAM_IMAGES_SHIFT | number of seed points, else 0 */
    float thin[4];   /* x, y: least factors of a stroke's length and width when it fades by size; z: number of seed
                        points */
};

/* All layers and the law of fading, std140. */
struct hatch_rptam_block {
    float front[4]; /* terms of hatch_fade_front with p = overlap: x: 2 p (1 - p); y, z, w: smallest f of the linear
                       part, its factor and its constant */
    float fade[4];  /* weight = x * front + y + z * life in steps, and + w for a stroke that stays; in a weighted set m
                       takes the place of front */
    float law[4]; /* x: 1 for HATCH_FADE_WEIGHTED, else 0; y: 1 for HATCH_FADE_PAPER, else 0; z: unused; w: steps of the
                     progress table per unit of mean darkness */
    int32_t counts[4]; /* x: number of layers; the others are unused */
    struct hatch_rptam_layer_block layers[HATCH_RPTAM_LAYERS_MAX];
};

/* A packed model; its arrays are in the arena of hatch_rptam_pack. Each list holds copies of its seed points, so that a
 * shader reads a seed point with one access. */
struct hatch_rptam_packed {
    struct hatch_rptam_block block;
    uint32_t *seeds;        /* 4 per entry of a list: u and v (as bits of floats), lives, lives in the next level */
    int32_t *lists;         /* 2 per list: its first entry in seeds, and one past its last */
    uint8_t *strokes;       /* 4 per texel of a stroke's image: alpha there, to the right, below, and below right */
    uint32_t *seed_numbers; /* per entry of seeds: the number of its seed point in the lower 16 bits; above them
                               HATCH_RPTAM_CRUMBS crumbs, lowest first: crumb k is 2 v + u for the position, modulo 2,
                               of those tiles whose stroke stays at the level after the next k */
    float progress[2 * HATCH_RPTAM_TONE_STEPS]; /* 2 per step of tone: its progress, and the difference to that of the
                                                   next step */
    bool varied;                                /* some layer is */
    struct hatch_rptam_lives *lives;            /* scratch while packing: 16 per seed point of a layer */
    size_t seed_count, list_count;              /* number of entries of seeds; of lists */
    size_t stroke_count;                        /* number of texels of strokes */
};

/* Packs a model.
 *   all  true: each layer has one list, with all strokes that may reach into the tile; slow to draw, for tests of the
 *        other lists */
enum hatch_status hatch_rptam_pack(const struct hatch_rptam *rptam, bool all, struct hatch_arena *arena,
                                   struct hatch_rptam_packed *packed, struct hatch_err *err) HATCH_MUST_USE;

#endif
