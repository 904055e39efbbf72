/* The file in which render-gl --needs says what the views of a scene need, needs(5). */
#ifndef HATCH_NEEDS_NEEDS_H
#define HATCH_NEEDS_NEEDS_H

#include <stdbool.h>

#include "base/bytes.h"
#include "curve/width.h"
#include "needs/regions.h"

#define HATCH_NEEDS_TONES 64u   /* parts of equal width of the scale of tones, from paper to ink */
#define HATCH_NEEDS_SLICE 4.0   /* greatest tone of a slice of a volume, in tolerances */
#define HATCH_NEEDS_COLUMN 1.5  /* greatest tone from a column of a map to the next, in tolerances */
#define HATCH_NEEDS_COLUMNS 6u  /* columns of a map, at least, where others are left out between them */
#define HATCH_NEEDS_SOLID 2.0   /* pixels per texel of a solid texture, at least */
#define HATCH_NEEDS_PATCHES 4.0 /* patches side by side on the largest item, at least */
#define HATCH_NEEDS_OCTAVES 24u /* octaves of pixels per unit of texture coordinates, from 1 pixel on */

struct hatch_needs {
    double tolerance;                   /* mean difference of tone that was allowed, over 0, at most 1 */
    double darkest;                     /* darkest tone that a view needs, of either ink, 0 .. 1 */
    bool relative;                      /* tones are shares of the darkest tone of the strokes, whatever it is */
    double unit_px[HATCH_NEEDS_TONES];  /* per part of the scale: most pixels that a unit of the scene's lengths at
                                           rest covers where a surface has such a tone; 0: none has */
    double texels[HATCH_NEEDS_OCTAVES]; /* per octave: share of the pixels whose finest mip level is of it */
    double solid_px;                    /* period of solid textures in pixels; 0: that of their size */
    double item_px;                     /* largest extent of an item in a picture; 0: unknown, or nothing is seen */
    struct hatch_needs_regions regions; /* its cells are the caller's, or NULL */
};

/* Parses a file of needs. Rows of other things are passed over.
 *   cells  HATCH_NEEDS_CELLS floats, out: those of the regions, kept by reference; unset on failure; NULL: rows of
 *          regions are passed over
 *   needs  out; unchanged on failure
 * HATCH_BAD_INPUT for a text that is no such table, a wrong number, or a row that is missing or cut. */
enum hatch_status hatch_needs_parse(struct hatch_bytes file, float *cells, struct hatch_needs *needs,
                                    struct hatch_err *err) HATCH_MUST_USE;

/* Returns how many columns of a map are needed: up to the first that is dark enough.
 *   targets  tones of the columns, ascending
 *   tones    number of columns, at least 1
 *   darkest  tone of the last column of the whole map, of which needs may be shares */
uint32_t hatch_needs_columns(const struct hatch_needs *needs, const float *targets, uint32_t tones, float darkest);

/* Returns n such that each n-th column of a map is enough: columns are at most HATCH_NEEDS_COLUMN tolerances apart
 * then. It is a power of two that divides their number.
 *   targets  tones of the columns, ascending
 *   tones    number of columns, at least 1 */
uint32_t hatch_needs_every(const struct hatch_needs *needs, const float *targets, uint32_t tones);

/* Returns the side of the finest level that a map needs, size_px or a smaller power of two, at least size_min_px. A
 * tile covers a unit of texture coordinates, or less. */
uint32_t hatch_needs_size(const struct hatch_needs *needs, uint32_t size_px, uint32_t size_min_px);

/* Returns the side that a tile of strokes on patches needs, size_px or a smaller power of two, at least size_min_px: no
 * patch is larger, so that no stroke repeats within one. Returns size_px where other surfaces than patches are seen,
 * or none. */
uint32_t hatch_needs_tile(const struct hatch_needs *needs, uint32_t size_px, uint32_t size_min_px);

/* Returns how many slices of tone a volume needs on its finest level: so many that on its coarsest one, a stroke
 * appears between slices that are at most HATCH_NEEDS_SLICE tolerances apart.
 *   levels  number of levels that hold strokes, each with half of the slices of the one before; 1: all have the same
 *   slices  a power of two; the result is one, too, at least 4 on the coarsest level, at most `slices` */
uint32_t hatch_needs_slices(const struct hatch_needs *needs, uint32_t levels, uint32_t slices);

/* Returns the texels along a side that a solid texture needs, size or a smaller power of two, at least size_min. */
uint32_t hatch_needs_solid(const struct hatch_needs *needs, uint32_t size, uint32_t size_min);

/* Returns how many traced strokes of a family are needed side by side per unit of the scene's lengths: what
 * hatch_stroke_width_px calls wanted, at most.
 *   mesh_px   most pixels that a unit of the scene's lengths covers on the mesh that has the strokes
 *   families  number of families of strokes, at least 1 */
double hatch_needs_strokes(const struct hatch_needs *needs, double mesh_px, const struct hatch_stroke_pen *pen,
                           uint32_t families);

#endif
