/* Volumes (Webb, Praun, Finkelstein & Hoppe, "Fine Tone Control in Hardware Hatching", NPAR 2002, §3.1): tonal art
 * maps as 3D textures whose third coordinate is tone. tamvol(5) describes the file.
 *
 * Tone t is the target darkness, 0 paper .. 1 ink, and the coordinate r = t. With D tones (struct
 * hatch_volume_options), level l has D >> l slices of size >> l pixels. Slice k holds the tone (k + 1/2) / (D >> l),
 * the coordinate at which a texture unit samples the slice's centre. With D = 64 the finest level has the tones 1/128,
 * 3/128 .. 127/128 and the next one 1/64, 3/64 .., so no tone is on two levels. Levels below the drawn ones are
 * box-filtered in all three directions.
 *
 * As an array (HATCH_VOLUME_ARRAY) every level has all D layers, and layer k holds the tone (k + 1/2) / D: the number
 * of tones does not fall with distance, and 2D filtering, also anisotropic, works as usual. A shader blends the two
 * layers around t D - 1/2.
 *
 * A volume of a map that is not whole leaves out slices darker than all that the map holds: it ends at a tone `top`
 * below 1, and coordinates are t / top. In three dimensions, the number of its slices is a multiple of 2^(l - 1) for l
 * drawn levels. */
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
    uint32_t tones; /* D: a power of two, HATCH_VOLUME_TONES_MIN .. HATCH_VOLUME_TONES_MAX */
    enum hatch_volume_layout layout;
    bool alpha; /* maps in colour: RGBA8 with alpha 255 instead of RGB8 */
};

/* Texels are reflectance, 255 paper and 0 ink: R8 for a grey map, RGB8 or RGBA8 for one in colour. */
struct hatch_volume {
    struct hatch_texels texels; /* depth D, or D layers; never block-compressed, see hatch_texels_decompress */
    uint32_t levels;            /* number of drawn levels */
    float darkest;              /* tone of the map's last column; slices of darker tones repeat that column */
    float top;                  /* tone at the end of the last slice, over 0 .. 1; 1: the volume is whole */
};

/* Differences between the tones of slices and columns, over all drawn levels. */
struct hatch_volume_figures {
    uint32_t slices;  /* number of slices */
    uint32_t blended; /* number of slices that are blends of two columns, or of paper and the first column, because
                         both differ from the slice by more than a quarter of the slice spacing; some strokes in
                         them are partly grey */
    double distance;  /* largest difference between the tone of a slice and that of the nearest column; paper counts
                         as a column of tone 0, and slices darker than the last column do not count */
};

#define HATCH_VOLUME_DISTANCE_MAX 0.25
#define HATCH_VOLUME_SLICES_FEW 4u /* with fewer slices, hardly any stroke of a level has its full strength */

/* Makes a volume. A slice is the nearest column if that lies within a quarter of the level's slice spacing (1 / D on
 * the finest level), else a blend of the two columns around it, or of paper and the first column. Slices darker than
 * the last column are that column. Does not check nesting.
 *   pool     NULL: one thread; the result is the same
 *   volume   out: its texels are in arena; unchanged on failure
 *   figures  out
 * HATCH_BAD_INPUT when a slice is further than HATCH_VOLUME_DISTANCE_MAX from every column. */
enum hatch_status hatch_volume_make(const struct hatch_tam *tam, const struct hatch_volume_options *options,
                                    struct hatch_pool *pool, struct hatch_arena *arena, struct hatch_volume *volume,
                                    struct hatch_volume_figures *figures, struct hatch_err *err) HATCH_MUST_USE;

/* Returns how many of the drawn levels of a volume have HATCH_VOLUME_SLICES_FEW slices or more, those that are left out
 * with them: the step of tone between slices makes strokes grey.
 *   texels  of the volume
 *   levels  number of drawn levels
 *   top     of the volume */
uint32_t hatch_volume_dense_levels(const struct hatch_texels *texels, uint32_t levels, double top);

/* Key of the file, beside HATCH_TAM_ATTR_LEVELS and HATCH_TAM_ATTR_SEED. */
#define HATCH_VOLUME_KEY_DARKEST "hatch:darkest"
#define HATCH_VOLUME_KEY_TOP "hatch:top" /* only where it is below 1 */

/* Interprets a file's texture as a volume.
 *   texels      its levels are kept by reference
 *   key_values  keys and values alternate, NULL-terminated, as from hatch_ktx2_read_keys
 *   volume      out; unchanged on failure
 * HATCH_BAD_INPUT for anything else. */
enum hatch_status hatch_volume_from_texels(const struct hatch_texels *texels, const char *const *key_values,
                                           struct hatch_volume *volume, struct hatch_err *err) HATCH_MUST_USE;

/* Samples a volume as a texture unit does: trilinearly within a level, linearly between two.
 *   u, v       texture coordinates, repeating
 *   tone       0 paper .. 1 ink
 *   lod        level of detail: 0 is the finest level, fractions lie between levels
 *   corrected  false: tones before the first and after the last slice are clamped to those slices. true: the
 *              border correction of the paper, which goes on from the first slice to paper at tone 0, and from the last
 *              one to the map's darkest tone, if that slice is lighter
 *   value      out: texels.channels numbers, 0 .. 1
 *
 * In a shader, for a whole volume, with CLAMP_TO_EDGE in r, light = 1 - min(t, darkest), and h and H half of the
 * distance between slices of the two levels whose texels are blended, with the share s of H (both 0.5 / D for an
 * array):
 *     held(x) = mix(max(x, h), max(x, H), s)
 *     (1 - (1 - texture) t / held(t)) light / held(light) */
void hatch_volume_sample(const struct hatch_volume *volume, float u, float v, float tone, float lod, bool corrected,
                         float *value);

#endif
