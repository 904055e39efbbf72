/* Tonal art maps as thresholds (Webb, Praun, Finkelstein & Hoppe, "Fine Tone Control in Hardware
 * Hatching", NPAR 2002, §3.2): for each texel a stair of darkness over tone, of at most
 * HATCH_THRESHOLD_BINS steps. tamthresh(5) is the file.
 *
 * Tone t is the darkness that is wanted, 0 paper to 1 ink. With all steps (x, dy) of a texel,
 *     reflectance = 1 - sum of dy over steps with t > x.
 * The steps are interpolated first, compared then: strokes have sharp edges at every magnification.
 * Bin b holds the step with border[b] <= x < border[b + 1] and nothing else, so that interpolation
 * never mixes x of different bins. Where a texel has no step in a bin, its dy is 0 and its x the mean of
 * its neighbours', weighted by their dy, so that it moves none of them; without such neighbours it is that
 * of the coarser level there, and of the last level the bin's middle.
 */
#ifndef HATCH_TAM_THRESHOLDS_H
#define HATCH_TAM_THRESHOLDS_H

#include <stdbool.h>

#include "base/parallel.h"
#include "image/texels.h"
#include "tam/tam.h"

#define HATCH_THRESHOLD_BINS 7u
#define HATCH_THRESHOLD_LAYERS 4u

/* Where each number of a texel stands in the four RGBA textures. In a shader:
 *     ink = dot(vec4(greaterThan(vec4(t), x0)), dy0) + dot(vec3(greaterThan(vec3(t), x1.rgb)), dy1.rgb) */
enum hatch_threshold_layer {
    HATCH_THRESHOLD_X0,  /* x of bins 0 .. 3 */
    HATCH_THRESHOLD_X1,  /* x of bins 4 .. 6, then the modulation m: 1 - t is multiplied by it; 1 by default */
    HATCH_THRESHOLD_DY0, /* dy of bins 0 .. 3 */
    HATCH_THRESHOLD_DY1  /* dy of bins 4 .. 6, then the outline mask: opacity; 1 by default */
};

struct hatch_threshold_options {
    uint32_t bins;       /* 1 .. HATCH_THRESHOLD_BINS; others stay empty */
    const float *border; /* bins + 1 tones, rising from 0 to 1; NULL: fitted, so
                            that merging and interpolating steps errs least */
    uint64_t seed;
    const struct hatch_image *modulation, *mask; /* first channel, 0 .. 1; resampled to the map; NULL: 1 */
};

struct hatch_thresholds {
    struct hatch_texels texels; /* RGBA8, HATCH_THRESHOLD_LAYERS layers, the whole mip chain */
    uint32_t levels;            /* that hold strokes */
    uint32_t bins;
    float border[HATCH_THRESHOLD_BINS + 1]; /* [bins] is 1 */
};

/* Of the drawn levels, before interpolation. */
struct hatch_threshold_figures {
    double steps;     /* mean number of steps of a texel in the map */
    double merged;    /* share of them that are in a bin with others */
    double error;     /* mean over texels and tones 0 .. 1 of |reflectance - the map's|, where the map is
                         a stair that changes half-way between two columns */
    double error_max; /* the largest of a texel, mean over tones */
};

/* Every level from the map's own. A step lies half-way between the tones of two columns (rounded down
 * where 8 bits lie between), so that at each column's tone its image comes out. Several steps in a bin
 * become one of the sum of their heights, at the x of one of them, which is drawn at random with a
 * chance in proportion to its height (so that the mean stays true): one lot, by seed and bin, for all texels
 * in which the same up to four steps meet, as along strokes; one for each texel with more.
 * HATCH_BAD_INPUT for a coloured map, and where a texel gets lighter (hatch_tam_check_nesting). */
enum hatch_status hatch_thresholds_make(const struct hatch_tam *tam, const struct hatch_threshold_options *options,
                                        struct hatch_pool *pool, struct hatch_arena *arena, struct hatch_arena *scratch,
                                        struct hatch_thresholds *thresholds, struct hatch_threshold_figures *figures,
                                        struct hatch_err *err) HATCH_MUST_USE;

/* The keys of the file beside HATCH_TAM_ATTR_LEVELS and HATCH_TAM_ATTR_SEED. */
#define HATCH_THRESHOLD_KEY_BORDERS "hatch:bins" /* bins + 1 numbers, separated by blanks */

/* Takes a file's texture over (nothing is copied). key_values: keys and values alternate,
 * NULL-terminated, as hatch_ktx2_read_keys gives them. HATCH_BAD_INPUT where it is none. */
enum hatch_status hatch_thresholds_from_texels(const struct hatch_texels *texels, const char *const *key_values,
                                               struct hatch_thresholds *thresholds,
                                               struct hatch_err *err) HATCH_MUST_USE;

/* The reflectance, 0 .. 1, at (u, v), repeating, tone and level of detail lod (0 is the finest): steps
 * bilinear within a level, linear between two, then compared. */
float hatch_thresholds_sample(const struct hatch_thresholds *thresholds, float u, float v, float tone, float lod);

#endif
