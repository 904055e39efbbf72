/* Recursive procedural tonal art maps in double precision: what a renderer draws, and the measure of
 * it (Algorithm 2 with the extensions that §6 and §8 name: layers, fading by opacity or size, together or one
 * after the other, weighted sets, and lists of the strokes near a place).
 *
 * A lighter tone of a layer is its pattern further out: of an amount a, the strokes are those that are there
 * log4(1/a) octaves further out, at the size that they have here. So what goes with a lighter tone is what would
 * go next with distance; strokes nest over both, and ink is in proportion to the amount. */
#ifndef HATCH_SEED_RPTAM_H
#define HATCH_SEED_RPTAM_H

#include "image/image.h"
#include "seed/coverage.h"
#include "seed/life.h"

#define HATCH_RPTAM_SEEDS_MAX 1024u
#define HATCH_RPTAM_LAYERS_MAX 64u
#define HATCH_RPTAM_STEPS 256u      /* of the table of tones */
#define HATCH_RPTAM_SIZES 4u        /* for which lists of strokes are made */
#define HATCH_RPTAM_REACH 8.0       /* tiles that a stroke may be long or wide */
#define HATCH_RPTAM_AMOUNT_MIN 1e-4 /* less of a layer is nothing */
#define HATCH_RPTAM_THIN_PX 1.0     /* strokes that shrink get no thinner and no shorter: they pale instead */
#define HATCH_RPTAM_GRAINS 8u       /* places at which a stroke's grain may begin; a power of two */

struct hatch_rptam_layer_style {
    double low, high;                 /* of the way from paper to the darkest, the stretch on which this layer comes in,
                                         0 <= low < high <= 1 */
    double angle_rad;                 /* of strokes to u */
    double length_px, width_px;       /* on the screen, over 0 */
    double tile_px;                   /* side of the seeds' tile at an integer depth, 1 / F of the paper: 8 .. 8192 */
    double ink;                       /* how dark a stroke is, over 0 .. 1 */
    const struct hatch_image *stroke; /* one channel: alpha, 0 .. 1, x along and y across, of any size: it
                                         is brought to the size that is drawn */
    const struct hatch_image *grain;  /* NULL, or one channel: repeats over the stroke, a pixel on the screen
                                         each, and multiplies it */
    bool varied; /* strokes differ, each the same for ever: some are mirrored across, and the grain begins at one of
                    HATCH_RPTAM_GRAINS places */
};

struct hatch_rptam_style {
    enum hatch_fade_law law;
    bool fade_size; /* strokes shrink; else they pale */
    double overlap; /* 0 .. 1: hatch_fade_at */
    uint32_t layer_count;
    struct hatch_rptam_layer_style layers[HATCH_RPTAM_LAYERS_MAX];
};

struct hatch_rptam_layer {
    struct hatch_rptam_layer_style style;
    uint32_t count;
    struct hatch_seed_place *places;
    double (*at)[2]; /* the same, rounded */
    uint8_t *life;   /* hatch_life_make */
    double cosine, sine;
    uint32_t images;           /* of the stroke, which follow one another: a power of two */
    struct hatch_image stroke; /* the first: alpha in steps of 1/255, at two texels a pixel, with a border of
                                  nothing; layers of the same share its pixels */
    struct hatch_coverage coverage[HATCH_RPTAM_SIZES]; /* for strokes of up to 2^(1 - i/2) of their size in
                                                          the tile */
};

struct hatch_rptam {
    struct hatch_rptam_style style;
    uint32_t layer_count;
    struct hatch_rptam_layer layers[HATCH_RPTAM_LAYERS_MAX]; /* their lows rising */
    double darkest;                                          /* the mean ink of all layers */
    double way[HATCH_RPTAM_STEPS + 1];                       /* how far the way leads to a tone of darkest i / STEPS */
};

/* Which look of 16 a seed's stroke has at a level: bit 3 mirrors it, the others choose its image. Seed i of one
 * level stays as seed i - 1 of the next. */
static inline uint32_t hatch_rptam_look(uint32_t seed, int level, uint32_t count)
{
    int64_t stroke = ((int64_t)seed + level) % (int64_t)count;
    return (uint32_t)(stroke < 0 ? stroke + (int64_t)count : stroke) * 2654435769u >> 28;
}

/* Images of strokes of this style, `images` of them, as in struct hatch_rptam_layer. */
enum hatch_status hatch_rptam_stroke(const struct hatch_rptam_layer_style *style, struct hatch_arena *arena,
                                     struct hatch_arena *scratch, struct hatch_image *stroke, uint32_t *images,
                                     struct hatch_err *err) HATCH_MUST_USE;

/* Layer i draws at set i; style->layers may come in any order. HATCH_BAD_INPUT where there are less sets
 * than layers, HATCH_LIMIT for sets of more than HATCH_RPTAM_SEEDS_MAX and strokes beyond HATCH_RPTAM_REACH. */
enum hatch_status hatch_rptam_make(const struct hatch_seeds *seeds, const struct hatch_rptam_style *style,
                                   struct hatch_arena *arena, struct hatch_arena *scratch, struct hatch_rptam *rptam,
                                   struct hatch_err *err) HATCH_MUST_USE;

/* How much of each layer, 0 .. 1, gives a darkness. amounts: layer_count entries. */
void hatch_rptam_amounts(const struct hatch_rptam *rptam, double darkness, double *amounts);

/* One layer at a depth and in an amount, to be looked at in many places. */
struct hatch_rptam_pattern {
    const struct hatch_rptam_layer *layer;
    const struct hatch_coverage *lists; /* for the size that strokes have in the tile; NULL: every seed */
    bool weighted, shrinks, nothing;
    struct hatch_fade fade;
    int level;      /* of the seeds */
    double scale;   /* tiles in a unit of texture coordinates, a power of two */
    double tile_px; /* its side on the screen */
};

/* depth, amount, all: as below. */
void hatch_rptam_pattern(const struct hatch_rptam *rptam, uint32_t layer, double depth, double amount, bool all,
                         struct hatch_rptam_pattern *pattern);

/* What it leaves of the paper at texture coordinates. */
double hatch_rptam_left(const struct hatch_rptam_pattern *pattern, const double uv[2]);

/* The share of ink that one layer puts at a place. uv: texture coordinates; depth: M of §5.1, any finite
 * number; amount: 0 .. 1. all: look at every seed, not only at the coverage's. */
double hatch_rptam_layer_ink(const struct hatch_rptam *rptam, uint32_t layer, const double uv[2], double depth,
                             double amount, bool all);

/* All layers at a place, at one depth: each covers what shines through those before it. amounts:
 * layer_count. */
double hatch_rptam_ink(const struct hatch_rptam *rptam, const double uv[2], double depth, const double *amounts,
                       bool all);

#endif
