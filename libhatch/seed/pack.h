/* Recursive procedural tonal art maps as uniform blocks and arrays for shaders. */
#ifndef HATCH_SEED_PACK_H
#define HATCH_SEED_PACK_H

#include "seed/rptam.h"

#define HATCH_RPTAM_IMAGES_SHIFT 16 /* of at[3] below; the lower bits hold the number of seed points */

/* A layer, std140, 80 bytes. */
struct hatch_rptam_layer_block {
    float turn[4];   /* cosine, sine of the strokes' direction; tile_px²; ink */
    float tone[4];   /* amount = x * progress + y; least progress with strokes; number of further lists, for smaller
                        strokes */
    float stroke[4]; /* texels per pixel, along and across; texels of the image minus 1, along and across */
    int32_t at[4];   /* first list; lists along the tile's side; first texel of the stroke; where strokes differ: images
                        << HATCH_RPTAM_IMAGES_SHIFT | seed points (their numbers), else 0 */
    float thin[4];   /* x, y: least factors of a stroke's length and width when it fades by size */
};

/* All layers and the law of fading, std140. */
struct hatch_rptam_block {
    float front[4]; /* of the fading front: 2 p (1 - p) with the overlap p; its linear part: start, factor, constant */
    float fade[4];  /* weight = x * front + y + z * life in steps (+ w in the next level) */
    float law[4]; /* 1: HATCH_FADE_WEIGHTED; 1: HATCH_FADE_PAPER; unused; tones of the progress table per unit of ink */
    int32_t counts[4]; /* number of layers; unused */
    struct hatch_rptam_layer_block layers[HATCH_RPTAM_LAYERS_MAX];
};

/* A packed model; its arrays are in the arena of hatch_rptam_pack. A seed point has an entry for each list that
 * contains it, so that shaders find it with one read. */
struct hatch_rptam_packed {
    struct hatch_rptam_block block;
    uint32_t *seeds;        /* 4 per seed entry: u and v (bits of floats), lives, lives in the next level */
    int32_t *lists;         /* 2 per list: its first seed entry, one past its last */
    uint8_t *strokes;       /* 4 per texel: alpha there, to the right, below, below right */
    uint16_t *seed_numbers; /* per seed entry: its seed point; NULL: no layer has differing strokes */
    float progress[2 * HATCH_RPTAM_TONE_STEPS]; /* 2 per tone: its progress, difference to that of the next tone */
    struct hatch_rptam_lives *lives;            /* scratch: 16 per seed point of a layer */
    size_t seed_count, list_count;              /* of seed entries; of lists */
    size_t stroke_count;                        /* texels of strokes */
};

/* Packs a model.
 *   all  true: every list has all strokes that may reach into the tile, for tests of the lists; slow to draw */
enum hatch_status hatch_rptam_pack(const struct hatch_rptam *rptam, bool all, struct hatch_arena *arena,
                                   struct hatch_rptam_packed *packed, struct hatch_err *err) HATCH_MUST_USE;

#endif
