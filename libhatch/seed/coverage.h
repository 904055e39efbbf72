/* Coverage lists: for each texel of the tile, a list of the strokes that may cover it. They replace the stroke
 * coverage texture of Recursive Procedural Tonal Art Maps, §6.1, and depend only on the positions, the size and the
 * direction of the strokes. */
#ifndef HATCH_SEED_COVERAGE_H
#define HATCH_SEED_COVERAGE_H

#include "seed/seeds.h"

/* One copy of a stroke in the plane over which the tile repeats: the stroke of a seed point, in the tile of column
 * tile_u and row tile_v. */
struct hatch_coverage_copy {
    uint32_t seed; /* index of the seed point */
    int32_t tile_u, tile_v;
};

/* Texel (x, y) covers x / side .. (x + 1) / side along u and y / side .. (y + 1) / side along v. The strokes that may
 * cover part of it are copies[first[y * side + x]] .. copies[first[y * side + x + 1] - 1], ordered by seed. */
struct hatch_coverage {
    uint32_t side;   /* texels along the tile */
    uint32_t *first; /* side * side + 1 entries */
    struct hatch_coverage_copy *copies;
};

struct hatch_coverage_stroke {
    double length, width; /* in tiles, may exceed 1; the stroke is centred on the seed point */
    double cosine, sine;  /* of its direction, measured from u towards v */
};

/* Makes the lists. A stroke is listed at a texel exactly where its rectangle and that of the texel intersect.
 *   points    count seed points
 *   side      1 .. 1024
 *   coverage  out, in arena
 * HATCH_LIMIT for 2^32 entries or more, or when memory does not suffice. */
enum hatch_status hatch_coverage_make(const struct hatch_seed_point *points, uint32_t count,
                                      const struct hatch_coverage_stroke *stroke, uint32_t side,
                                      struct hatch_arena *arena, struct hatch_coverage *coverage,
                                      struct hatch_err *err) HATCH_MUST_USE;

#endif
