/* Threshold textures (Webb, Praun, Finkelstein & Hoppe, "Fine Tone Control in Hardware Hatching", NPAR 2002, §3.2):
 * for each texel a step function of darkness over tone, with at most HATCH_THRESHOLD_BINS steps. tamthresh(5)
 * describes the file.
 *
 * Tone t is the target darkness, 0 paper .. 1 ink. A step (x, dy) raises the texel's darkness by dy at tone x:
 *     reflectance = 1 - sum of dy over the steps with t > x.
 * Steps are interpolated before the comparison, so strokes have sharp edges at every magnification. Bin b holds only a
 * step with border[b] <= x < border[b + 1], so interpolation never mixes the x of different bins. A texel without a
 * step in a bin has dy 0 there; its x is the mean of its neighbours' x, weighted by their dy, so that interpolation
 * does not shift theirs. Without such neighbours it is the x of the coarser level, and on the coarsest level the
 * middle of the bin. */
#ifndef HATCH_TAM_THRESHOLDS_H
#define HATCH_TAM_THRESHOLDS_H

#include <stdbool.h>

#include "base/parallel.h"
#include "image/block_compress.h"
#include "tam/tam.h"

#define HATCH_THRESHOLD_BINS 7u
#define HATCH_THRESHOLD_LAYERS 4u
#define HATCH_THRESHOLD_BINS_FEW 4u                                    /* most bins that two layers hold */
#define HATCH_THRESHOLD_LAYERS_FEW 2u                                  /* X0 and DY0; modulation and mask are 1 */
#define HATCH_THRESHOLD_LAYERS_BLOCKS (4 * HATCH_THRESHOLD_LAYERS_FEW) /* one for each channel of these */

/* Layers of the RGBA texture array. In a shader:
 *     ink = dot(vec4(greaterThan(vec4(t), x0)), dy0) + dot(vec3(greaterThan(vec3(t), x1.rgb)), dy1.rgb) */
enum hatch_threshold_layer {
    HATCH_THRESHOLD_X0,  /* x of bins 0 .. 3 */
    HATCH_THRESHOLD_X1,  /* RGB: x of bins 4 .. 6; alpha: modulation, a factor of 1 - t; default 1 */
    HATCH_THRESHOLD_DY0, /* dy of bins 0 .. 3 */
    HATCH_THRESHOLD_DY1  /* RGB: dy of bins 4 .. 6; alpha: outline mask, an opacity; default 1 */
};

struct hatch_threshold_options {
    uint32_t bins;                        /* 1 .. HATCH_THRESHOLD_BINS; the others stay empty */
    const float *border;                  /* bins + 1 tones from 0 to 1, rising; NULL: fitted for the least error */
    uint64_t seed;                        /* random seed */
    const struct hatch_image *modulation; /* first channel, 0 .. 1, resampled to the map; NULL: 1 */
    const struct hatch_image *mask;       /* likewise */
};

/* Error of thresholds over the drawn levels, without interpolation. */
struct hatch_threshold_figures {
    double steps;     /* mean number of steps per texel of the map */
    double merged;    /* share of them that lie in a bin with others, 0 .. 1 */
    double error;     /* mean over texels and tones 0 .. 1 of |reflectance - the map's|, where the map is a step
                         function that changes half-way between two columns */
    double error_max; /* largest such mean over tones of a single texel */
};

struct hatch_thresholds {
    struct hatch_texels texels; /* RGBA8, HATCH_THRESHOLD_LAYERS layers or, with few bins, HATCH_THRESHOLD_LAYERS_FEW;
                                   full mip chain */
    uint32_t levels;            /* number of drawn levels */
    uint32_t bins;
    float border[HATCH_THRESHOLD_BINS + 1]; /* border[bins] is 1 */
    struct hatch_threshold_figures figures; /* zeros when read from a file */
};

/* Makes every level from the map's level. A step lies half-way between the tones of two columns, rounded to below that
 * of the darker one, so that sampling at the tone of a column yields its image, or that of the next if it is less than
 * 1/255 darker. Several steps in a bin are merged into one with the sum of their heights. Its
 * x is that of a random one of them, chosen with a probability in proportion to its height, which keeps the mean
 * reflectance. All texels in which the same steps meet, at most four, use one random number, which follows from seed,
 * bin and steps, so that crossing strokes stay whole; a texel with more steps in a bin has a random number of its own.
 *   pool        NULL: one thread; the result is the same
 *   thresholds  out: its texels are in arena; unchanged on failure
 * HATCH_BAD_INPUT for a map in colour and where a texel gets lighter (hatch_tam_check_nesting). */
enum hatch_status hatch_thresholds_make(const struct hatch_tam *tam, const struct hatch_threshold_options *options,
                                        struct hatch_pool *pool, struct hatch_arena *arena, struct hatch_arena *scratch,
                                        struct hatch_thresholds *thresholds, struct hatch_err *err) HATCH_MUST_USE;

/* Leaves out the layers that are empty with at most HATCH_THRESHOLD_BINS_FEW bins, which must have neither modulation
 * nor mask. */
void hatch_thresholds_pack(struct hatch_thresholds *thresholds);

/* Compresses thresholds of few bins as BC4, in half of the bytes: each channel of their two layers becomes a layer, in
 * this order. Within a block x keeps its range, so that it stays in its bin.
 *   thresholds  after hatch_thresholds_pack
 *   pool        NULL: one thread; the result is the same
 *   packed      out, in arena; unchanged on failure
 *   figures     out: errors of x and dy together */
enum hatch_status hatch_thresholds_compress(const struct hatch_thresholds *thresholds, struct hatch_pool *pool,
                                            struct hatch_arena *arena, struct hatch_texels *packed,
                                            struct hatch_block_figures *figures, struct hatch_err *err) HATCH_MUST_USE;

/* Returns compressed thresholds as two layers again, decompressed; other textures as they are, without a copy.
 *   file    a file's texture
 *   texels  out, in arena; unchanged on failure; may be file
 * HATCH_BAD_INPUT for blocks in another number of layers. */
enum hatch_status hatch_thresholds_decompress(const struct hatch_texels *file, struct hatch_arena *arena,
                                              struct hatch_texels *texels, struct hatch_err *err) HATCH_MUST_USE;

/* Key of the file, beside HATCH_TAM_ATTR_LEVELS and HATCH_TAM_ATTR_SEED. */
#define HATCH_THRESHOLD_KEY_BORDERS "hatch:bins" /* bins + 1 numbers, separated by spaces */

/* Interprets a file's texture as threshold textures.
 *   texels      from hatch_thresholds_decompress; its levels are kept by reference
 *   key_values  keys and values alternate, NULL-terminated, as from hatch_ktx2_read_keys
 *   thresholds  out; unchanged on failure
 * HATCH_BAD_INPUT for anything else. */
enum hatch_status hatch_thresholds_from_texels(const struct hatch_texels *texels, const char *const *key_values,
                                               struct hatch_thresholds *thresholds,
                                               struct hatch_err *err) HATCH_MUST_USE;

/* Returns the reflectance, 0 .. 1. Steps are filtered bilinearly within a level and linearly between two levels, then
 * compared with the tone.
 *   u, v  texture coordinates, repeating
 *   tone  0 paper .. 1 ink
 *   lod   level of detail: 0 is the finest level, fractions lie between levels */
float hatch_thresholds_sample(const struct hatch_thresholds *thresholds, float u, float v, float tone, float lod);

#endif
