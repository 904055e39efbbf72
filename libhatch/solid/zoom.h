/* Infinite zoom on solid textures: a blend of octaves in which the texture keeps its size on the screen at every
 * distance (Bénard, Bousseau & Thollot, "Dynamic Solid Textures for Real-Time Coherent Stylization", I3D 2009, §3).
 *
 * A zoom cycle is a doubling of the distance; s, 0 .. 1, is the progress within it. At place p, in periods of the
 * texture T at the beginning of the cycle, the paper's blend of four octaves is
 *     B_s(p) = a1 T(p / 2) + a2 T(p) + a3 T(2 p) + a4 T(4 p)
 * with the weights of hatch_zoom_weights. They are linear in s, so that the blend is one of two scales of one texture:
 *     B_s(p) = (1 - s) A(p) + s A(p / 2),    A(p) = T(p) / 2 + T(2 p) / 3 + T(4 p) / 6
 * A is made once (hatch_zoom_make); shaders read it twice per fragment instead of T four times.
 *
 * Sums of octaves blur marks such as dots. HATCH_ZOOM_UNION keeps them: A has the ranks of T's values, 0 .. 1 (equal
 * ones, if many, by what is around them: zoom/ranks.h), and a place is inked where it is in a mark of either octave,
 * those of A(p) covering f and those of A(p / 2) covering c of the surface. At tone t, f - c = (1 - 2 s) t, so that
 * those of the finer octave shrink evenly to nothing while those of the coarser one grow, and 1 - (1 - f) (1 - c) = t,
 * as if octaves did not depend on each other. Solved for the tone at which a place appears, B_s(p) = min(u(A(p), s),
 * u(A(p / 2), 1 - s)),    u(a, s) = a (2 - a) / (1 + (1 - a) (1 - 2 s)) */
#ifndef HATCH_SOLID_ZOOM_H
#define HATCH_SOLID_ZOOM_H

#include <stdbool.h>

#include "base/parallel.h"
#include "solid/solid.h"

#define HATCH_ZOOM_OCTAVES 4u

/* Computes the weights of the four octaves, lowest frequency first (§3.2).
 *   s        progress within the cycle, 0 .. 1
 *   weights  out: their sum is 1 */
void hatch_zoom_weights(double s, double weights[HATCH_ZOOM_OCTAVES]);

/* How blended values are changed to make up for the contrast that blending loses. */
enum hatch_zoom_blend {
    HATCH_ZOOM_LINEAR,    /* the paper's blend, unchanged */
    HATCH_ZOOM_CONTRAST,  /* deviations from the mean are scaled to those of T, and clamped */
    HATCH_ZOOM_HISTOGRAM, /* the values' distribution becomes that of T, in the spirit of Heitz & Neyret, "High-
                             Performance By-Example Noise using a Histogram-Preserving Blending Operator", 2018 */
    HATCH_ZOOM_UNION,     /* marks of two octaves; a value becomes the share of lower values: thresholds for tones */
    HATCH_ZOOM_RANK       /* the paper's blend as such thresholds */
};

/* The texture A of a solid texture. Its values are coordinates along axes without correlation (principal components of
 * the texels of T), so that channels can be changed one by one: the colour of a texel with values v_c, 0 .. 1, is
 * offset + the sum of v_c axes[c]. */
struct hatch_zoom {
    struct hatch_solid octaves; /* A */
    struct hatch_solid base;    /* T in the same coordinates */
    float offset[3], axes[3][3];
};

/* Makes the texture A.
 *   size  texels along a side of A: a power of two, HATCH_SOLID_SIZE_MIN to four times the size of T; octaves that are
 *         finer than its texels are averaged
 *   grey  the luminance of a coloured texture is used
 *   blend it is made for
 *   zoom  out: in arena; one channel if grey
 * HATCH_LIMIT when the memory does not suffice. */
enum hatch_status hatch_zoom_make(const struct hatch_solid *solid, uint32_t size, bool grey,
                                  enum hatch_zoom_blend blend, struct hatch_pool *pool, struct hatch_arena *arena,
                                  struct hatch_arena *scratch, struct hatch_zoom *zoom,
                                  struct hatch_err *err) HATCH_MUST_USE;

/* Makes the mip chain of A. With LINEAR a texel is the mean of eight; otherwise deviations from the mean are then
 * scaled to those of the finest level, at most HATCH_ZOOM_GAIN_MAX times, so that slanted surfaces keep their contrast.
 *   mips  out: in arena; the finest level is that of zoom->octaves
 * HATCH_LIMIT when the memory does not suffice. */
enum hatch_status hatch_zoom_mips(const struct hatch_zoom *zoom, enum hatch_zoom_blend blend, struct hatch_arena *arena,
                                  struct hatch_texels *mips, struct hatch_err *err) HATCH_MUST_USE;

#define HATCH_ZOOM_GAIN_MAX 4.0
#define HATCH_ZOOM_VALUES 256u
#define HATCH_ZOOM_STEPS 17u /* of s: 0, 1/16 .. 1 */

/* The change as a table. The entry of value i stands for the blended value (i + 0.5) / HATCH_ZOOM_VALUES. */
struct hatch_zoom_table {
    uint16_t (*entries)[HATCH_ZOOM_STEPS][HATCH_ZOOM_VALUES]; /* one per channel; 65535 is 1 */
};

/* Makes the table of a blend.
 *   mips   of hatch_zoom_mips
 *   level  mip level, with fractions, at which a surface that faces the eye shows A(p) at the beginning of a cycle;
 *          below 0 where texels are larger than pixels
 *   table  out: in arena
 * HATCH_LIMIT when the memory does not suffice. */
enum hatch_status hatch_zoom_table_make(const struct hatch_zoom *zoom, const struct hatch_texels *mips,
                                        enum hatch_zoom_blend blend, double level, struct hatch_arena *arena,
                                        struct hatch_arena *scratch, struct hatch_zoom_table *table,
                                        struct hatch_err *err) HATCH_MUST_USE;

/* Reads a 3D texture, interpolated between texels and between levels, the texture being repeated.
 *   level  with fractions; beyond the chain, its first or last level
 *   place  in periods
 *   value  out: one per channel, 0 .. 1 */
void hatch_zoom_sample(const struct hatch_texels *mips, float level, const float place[3], float value[3]);

/* Computes a blended value as shaders do, before a table changes it.
 *   place  in periods of T
 *   s      progress within the cycle, 0 .. 1
 *   level  mip level for A(p); A(p / 2) is read one level finer
 *   value  out: one per channel */
void hatch_zoom_blend_at(const struct hatch_texels *mips, enum hatch_zoom_blend blend, const float place[3], float s,
                         float level, float value[3]);

#endif
