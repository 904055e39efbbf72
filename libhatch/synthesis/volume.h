/* A solid while it is made: its texels, and for each texel and axis its match, the neighbourhood of the exemplar that
 * resembles the one around the texel in the slice across that axis. */
#ifndef HATCH_SYNTHESIS_VOLUME_H
#define HATCH_SYNTHESIS_VOLUME_H

#include <stdbool.h>

#include "base/parallel.h"
#include "synthesis/exemplar.h"

enum { HATCH_AXES = 3 };

struct hatch_volume {
    uint32_t size, channels;
    uint32_t axes;                 /* bit a: slices across axis a have matches */
    uint8_t *texels;               /* as in struct hatch_solid */
    uint8_t *next;                 /* the texels of the next iteration */
    uint16_t *matches[HATCH_AXES]; /* [(slice * size + row) * size + column]: names of neighbourhoods; pixel
                                      (side / 2, side / 2) of the neighbourhood lies on the texel */
};

/* Steps from texel to texel in the slices across an axis. */
struct hatch_slices {
    size_t slice, row, column;
};

static inline struct hatch_slices hatch_slices_of(uint32_t axis, uint32_t size)
{
    const size_t x = 1, y = size, z = (size_t)size * size;
    const struct hatch_slices slices[HATCH_AXES] = {{x, z, y}, {y, z, x}, {z, y, x}};
    return slices[axis];
}

static inline bool hatch_volume_has(const struct hatch_volume *volume, uint32_t axis)
{
    return volume->axes >> axis & 1;
}

static inline uint32_t hatch_volume_axis_count(const struct hatch_volume *volume)
{
    return (volume->axes & 1) + (volume->axes >> 1 & 1) + (volume->axes >> 2 & 1);
}

static inline size_t hatch_volume_count(const struct hatch_volume *volume)
{
    return (size_t)volume->size * volume->size * volume->size;
}

/* Sets texels and matches to random ones of the exemplar. */
void hatch_volume_randomize(const struct hatch_volume *volume, const struct hatch_exemplar *exemplar, uint64_t key);

/* Sets texels and matches to those of a volume of half the size, made with an exemplar of half the size. */
void hatch_volume_refine(const struct hatch_volume *coarse, const struct hatch_exemplar *coarse_exemplar,
                         const struct hatch_volume *volume, const struct hatch_exemplar *exemplar);

/* Copies the neighbourhood of the texel in column u and row v of a slice.
 *   side    of neighbourhoods
 *   values  out: [side * side * channels], row by row: 8-bit values - 128 */
void hatch_volume_gather(const struct hatch_volume *volume, uint32_t side, uint32_t axis, uint32_t slice, uint32_t u,
                         uint32_t v, int16_t *values);

/* Computes the energy of struct hatch_synthesis_figures. */
enum hatch_status hatch_volume_energy(const struct hatch_volume *volume, const struct hatch_exemplar *exemplar,
                                      struct hatch_pool *pool, struct hatch_arena *scratch, double *energy,
                                      struct hatch_err *err) HATCH_MUST_USE;

#endif
