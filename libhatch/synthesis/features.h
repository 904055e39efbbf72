/* Features of neighbourhoods: their projections onto the principal components of all neighbourhoods of the exemplar, in
 * 16 bits. Distances between features approximate those between neighbourhoods. */
#ifndef HATCH_SYNTHESIS_FEATURES_H
#define HATCH_SYNTHESIS_FEATURES_H

#include "base/parallel.h"
#include "synthesis/exemplar.h"

#define HATCH_FEATURES 16u        /* components of a feature */
#define HATCH_FEATURES_SCALE 4    /* a feature is a projection of 8-bit values times this */
#define HATCH_FEATURES_SIMILAR 3u /* similar neighbourhoods that are kept of each */

struct hatch_features {
    uint32_t length;   /* of a row of the basis, a multiple of 16: side * side * channels, then zeros */
    int16_t *basis;    /* [component * length + i], times 2^12 */
    int16_t *vectors;  /* [(y * across + x) * HATCH_FEATURES + component] */
    uint16_t *similar; /* NULL, or [(y * across + x) * HATCH_FEATURES_SIMILAR + i]: names of neighbourhoods, most
                          similar first */
};

/* Returns the memory that hatch_features_make takes, with its temporary data. */
size_t hatch_features_bytes(const struct hatch_exemplar *exemplar);

/* Computes the features of all neighbourhoods of an exemplar.
 *   similar  find those that are similar to each, too */
enum hatch_status hatch_features_make(const struct hatch_exemplar *exemplar, bool similar, struct hatch_pool *pool,
                                      struct hatch_arena *arena, struct hatch_arena *scratch,
                                      struct hatch_features *features, struct hatch_err *err) HATCH_MUST_USE;

/* Projects a neighbourhood.
 *   values   [features->length], row by row, -128 .. 127, then zeros
 *   feature  out */
void hatch_features_project(const struct hatch_features *features, const int16_t *values,
                            int16_t feature[HATCH_FEATURES]);

/* Returns the squared distance of two features. */
static inline uint32_t hatch_features_distance(const int16_t *a, const int16_t *b)
{
    int32_t sum = 0;
    for (uint32_t i = 0; i < HATCH_FEATURES; i++) {
        int32_t d = (int16_t)(a[i] - b[i]); /* fits: |a - b| is at most 255 sqrt(length) scale, below 2^15 */
        sum += d * d;
    }
    return (uint32_t)sum;
}

#endif
