/* Recursive procedural tonal art maps in double precision (Szécsi & Szirányi 2014, Algorithm 2 with the extensions of
 * §6 and §8: layers, fading by opacity or size, together or one after the other, weighted sets, and coverage lists).
 * This is the model that a renderer draws, and the reference against which it is tested.
 *
 * For a lighter tone, a layer keeps only the strokes that would be left if the view were further out, at their present
 * size: for an amount a, 0 .. 1, those present log4(1/a) octaves further out. Strokes therefore nest over tones as they
 * do over distance, and ink is proportional to the amount. */
#ifndef HATCH_SEED_RPTAM_H
#define HATCH_SEED_RPTAM_H

#include "image/image.h"
#include "seed/coverage.h"
#include "seed/life.h"

#define HATCH_RPTAM_SEEDS_MAX 1024u
#define HATCH_RPTAM_LAYERS_MAX 64u
#define HATCH_RPTAM_TONE_STEPS 256u      /* steps of the table `progress` */
#define HATCH_RPTAM_COVERAGE_SIZES 4u    /* sizes of strokes for which coverage lists are made */
#define HATCH_RPTAM_STROKE_TILES_MAX 8.0 /* largest length and width of a stroke, tiles */
#define HATCH_RPTAM_AMOUNT_MIN 1e-4      /* a layer with a smaller amount is not drawn */
#define HATCH_RPTAM_THIN_PX 1.0 /* a stroke that fades by size gets no shorter or thinner; from there on it pales */
#define HATCH_RPTAM_GRAIN_OFFSETS 8u /* largest number of images of a stroke that differ in grain, a power of two */

struct hatch_rptam_layer_style {
    double low, high; /* range of progress over which the layer is added, 0 <= low < high <= 1; progress runs from blank
                         paper, 0, to all layers complete, 1 */
    double angle_rad; /* direction of strokes, measured from u towards v */
    double length_px, width_px; /* size of a stroke on screen, greater than 0 */
    double tile_px; /* side of the seed set's tile on screen at a nesting level (1 / F in the paper), 8 .. 8192 */
    double ink;     /* darkness of a stroke, 0 < ink <= 1 */
    const struct hatch_image *stroke; /* one channel, alpha, 0 .. 1, x along and y across, of any size */
    const struct hatch_image *grain; /* one channel: repeating factor for alpha, a texel per screen pixel; NULL: none */
    bool varied; /* strokes differ from each other, but each stays the same over time: some are mirrored across, and the
                    grain of each has one of HATCH_RPTAM_GRAIN_OFFSETS offsets */
};

struct hatch_rptam_style {
    enum hatch_fade_law law;
    bool fade_size; /* true: strokes fade by shrinking; false: by opacity */
    double overlap; /* as for hatch_fade_at, 0 .. 1 */
    uint32_t layer_count;
    struct hatch_rptam_layer_style layers[HATCH_RPTAM_LAYERS_MAX];
};

struct hatch_rptam_layer {
    struct hatch_rptam_layer_style style;
    uint32_t count; /* number of seed points */
    struct hatch_seed_point *points;
    double (*positions)[2];    /* the points as fractions of the tile */
    uint8_t *life;             /* lifetimes from hatch_life_make */
    double cosine, sine;       /* of the strokes' direction */
    uint32_t images;           /* number of images of the stroke, a power of two; they are contiguous */
    struct hatch_image stroke; /* the first of them: alpha in steps of 1/255, up to two texels per pixel, with a border
                                  of 0; layers with the same stroke share its pixels */
    struct hatch_coverage coverage[HATCH_RPTAM_COVERAGE_SIZES]; /* [i]: for strokes of up to 2^(1 - i/2) times their
                                                                   size at a nesting level */
};

struct hatch_rptam {
    struct hatch_rptam_style style;
    uint32_t layer_count;
    struct hatch_rptam_layer layers[HATCH_RPTAM_LAYERS_MAX]; /* in ascending order of low */
    double darkest;                                          /* mean darkness of all layers complete */
    double progress[HATCH_RPTAM_TONE_STEPS + 1]; /* [i]: progress for a mean darkness of darkest * i / TONE_STEPS */
};

/* Returns the variant of a stroke, 0 .. 15: bit 3 tells whether it is mirrored, the lower bits choose its image. A
 * stroke keeps its variant over nesting levels, where seed point i of one level is seed point i - 1 of the next.
 *   count  number of seed points */
static inline uint32_t hatch_rptam_variant(uint32_t seed, int level, uint32_t count)
{
    int64_t stroke = ((int64_t)seed + level) % (int64_t)count;
    return (uint32_t)(stroke < 0 ? stroke + (int64_t)count : stroke) * 2654435769u >> 28;
}

/* Makes the images of a layer's strokes at their size on screen.
 *   stroke  out: the first image, in arena
 *   images  out: their number, as in struct hatch_rptam_layer */
enum hatch_status hatch_rptam_stroke_images(const struct hatch_rptam_layer_style *style, struct hatch_arena *arena,
                                            struct hatch_arena *scratch, struct hatch_image *stroke, uint32_t *images,
                                            struct hatch_err *err) HATCH_MUST_USE;

/* Makes the model; layer i of the style uses seed set i.
 *   style  its layers may be in any order; its images are not kept
 *   rptam  out, in arena; unchanged on failure
 * HATCH_BAD_INPUT for fewer seed sets than layers; HATCH_LIMIT for sets of more than HATCH_RPTAM_SEEDS_MAX seed points
 * and for strokes larger than HATCH_RPTAM_STROKE_TILES_MAX. */
enum hatch_status hatch_rptam_make(const struct hatch_seeds *seeds, const struct hatch_rptam_style *style,
                                   struct hatch_arena *arena, struct hatch_arena *scratch, struct hatch_rptam *rptam,
                                   struct hatch_err *err) HATCH_MUST_USE;

/* One layer at a depth and an amount, to be evaluated at many positions. */
struct hatch_rptam_pattern {
    const struct hatch_rptam_layer *layer;
    const struct hatch_coverage *lists; /* those for the present size of strokes; NULL: test every seed point */
    bool weighted, shrinks;
    bool empty; /* the amount is below HATCH_RPTAM_AMOUNT_MIN */
    struct hatch_fade fade;
    int level;      /* nesting level of the seed set */
    double scale;   /* tiles per unit of texture coordinates, a power of two */
    double tile_px; /* side of the tile on screen */
};

/* Makes the pattern of a layer.
 *   depth   M of §5.1, any finite number
 *   amount  0 .. 1
 *   all     true: test every seed point instead of those on the coverage lists */
void hatch_rptam_pattern_make(const struct hatch_rptam *rptam, uint32_t layer, double depth, double amount, bool all,
                              struct hatch_rptam_pattern *pattern);

/* Returns the transmittance at uv, 0 .. 1. */
double hatch_rptam_transmittance(const struct hatch_rptam_pattern *pattern, const double uv[2]);

#endif
