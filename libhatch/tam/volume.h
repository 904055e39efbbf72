/* Tonal art maps as volumes (Webb, Praun, Finkelstein & Hoppe, "Fine Tone Control in Hardware
 * Hatching", NPAR 2002, §3.1): tone is the third coordinate of a 3D texture. tamvol(5) is the file.
 *
 * Tone t is the darkness that is wanted, 0 paper to 1 ink, and the coordinate r = t. Level l has
 * D >> l slices of size >> l pixels; slice k of them holds the tone (k + 1/2) / (D >> l), which is
 * where a texture unit has its samples: with D = 64 the finest level has 1/128, 3/128 .. 127/128, the
 * next one 1/64, 3/64 .., and no tone stands on two levels. Levels below the last drawn one are box
 * filtered in all three directions.
 *
 * As an array (HATCH_VOLUME_ARRAY) every level has all D layers, layer k the tone (k + 1/2) / D: the
 * tones do not get fewer with distance, and 2D filtering, anisotropic too, stays what it is. A shader
 * blends the two layers next to t D - 1/2.
 */
#ifndef HATCH_TAM_VOLUME_H
#define HATCH_TAM_VOLUME_H

#include <stdbool.h>

#include "base/parallel.h"
#include "image/texels.h"
#include "tam/tam.h"

#define HATCH_VOLUME_TONES_MIN 2u
#define HATCH_VOLUME_TONES_MAX 256u

enum hatch_volume_layout { HATCH_VOLUME_3D, HATCH_VOLUME_ARRAY };

struct hatch_volume_options {
    uint32_t tones; /* D: a power of two, HATCH_VOLUME_TONES_MIN .. MAX */
    enum hatch_volume_layout layout;
    bool alpha; /* coloured maps: RGBA8, alpha 255, in place of RGB8 */
};

/* Reflectance, 255 paper and 0 ink: R8 of a grey map; RGB8 or RGBA8 of a coloured one. */
struct hatch_volume {
    struct hatch_texels texels; /* depth D, or layers D; never compressed: see hatch_texels_unpack */
    uint32_t levels;            /* that hold strokes */
    float darkest;              /* tone of the map's last column; above it, slices repeat that column */
};

/* What was not in the map as it is wanted. Distances are of tone. */
struct hatch_volume_figures {
    uint32_t slices;  /* of all drawn levels */
    uint32_t blended; /* of them, those further than a quarter of a slice's step from any column:
                         a blend of both neighbours, whose strokes are partly grey */
    double distance;  /* the largest between a slice's tone and the nearest column; paper is one at 0,
                         and what lies above the last column does not count */
};

/* Fills a volume: each slice is the nearest column, where one lies within a quarter of the level's step
 * (1 / D at the finest), else the two columns around it, blended. HATCH_BAD_INPUT when a column is
 * missing by more than HATCH_VOLUME_DISTANCE_MAX. Nesting is not looked at. pool: NULL is one thread;
 * the result is the same. */
#define HATCH_VOLUME_DISTANCE_MAX 0.25
enum hatch_status hatch_volume_make(const struct hatch_tam *tam, const struct hatch_volume_options *options,
                                    struct hatch_pool *pool, struct hatch_arena *arena, struct hatch_volume *volume,
                                    struct hatch_volume_figures *figures, struct hatch_err *err) HATCH_MUST_USE;

/* The keys of the file beside HATCH_TAM_ATTR_LEVELS and HATCH_TAM_ATTR_SEED. */
#define HATCH_VOLUME_KEY_DARKEST "hatch:darkest"

/* Takes a file's texture over as a volume (nothing is copied). key_values: keys and values alternate,
 * NULL-terminated, as hatch_ktx2_read_keys gives them. HATCH_BAD_INPUT where it is none. */
enum hatch_status hatch_volume_from_texels(const struct hatch_texels *texels, const char *const *key_values,
                                           struct hatch_volume *volume, struct hatch_err *err) HATCH_MUST_USE;

/* What a texture unit returns at (u, v), repeating, tone and level of detail lod (0 is the finest, may
 * be between levels): trilinear within a level, linear between two. value: texels.channels numbers,
 * 0 .. 1. corrected: with the paper's border correction, which begins at the first sample and takes all
 * of the paper's white at tone 0, and all of the ink at tone 1 where darkest is 1; else r is clamped to
 * the first and last samples. An array is corrected by the same rule with its one step.
 *
 * In a shader, with CLAMP_TO_EDGE in r, h = 0.5 exp2(lod) / D (0.5 / D for an array):
 *     mix(1, mix(texture, 0, darkest < 1 ? 0 : max(0, t - 1 + h) / h), min(1, t / h)) */
void hatch_volume_sample(const struct hatch_volume *volume, float u, float v, float tone, float lod, bool corrected,
                         float *value);

#endif
