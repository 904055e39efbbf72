/* Coverage lists: the strokes that may cover each texel of the tile, as lists instead of the stroke coverage texture of
 * Recursive Procedural Tonal Art Maps, §6.1. They depend on the size and direction of the strokes only. */
#ifndef HATCH_SEED_COVERAGE_H
#define HATCH_SEED_COVERAGE_H

#include "seed/seeds.h"

/* A stroke in the plane over which the tile repeats: that of a seed point, in the tile of a column and a row. */
struct hatch_coverage_copy {
    uint32_t seed; /* index of the seed point */
    int32_t tile_u, tile_v;
};

/* Texel (x, y) covers [x, x + 1) by [y, y + 1) over side. The strokes that may cover part of it are
 * copies[first[y * side + x]] .. copies[first[y * side + x + 1] - 1], ordered by seed. */
struct hatch_coverage {
    uint32_t side;   /* texels along the tile */
    uint32_t *first; /* side * side + 1 entries */
    struct hatch_coverage_copy *copies;
};

struct hatch_coverage_stroke {
    double length, width; /* fractions of the tile, may exceed 1; the middle is on the seed point */
    double cosine, sine;  /* of its direction, from u to v */
};

/* Makes the lists. A stroke is listed exactly where its rectangle and that of the texel intersect.
 *   points    count seed points
 *   side      1 .. 1024
 *   coverage  out, in arena
 * HATCH_LIMIT for more than 2^32 entries, or when memory does not suffice. */
enum hatch_status hatch_coverage_make(const struct hatch_seed_point *points, uint32_t count,
                                      const struct hatch_coverage_stroke *stroke, uint32_t side,
                                      struct hatch_arena *arena, struct hatch_coverage *coverage,
                                      struct hatch_err *err) HATCH_MUST_USE;

#endif
