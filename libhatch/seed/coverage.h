/* Which strokes may cover a place in the tile: the stroke coverage texture of Recursive Procedural Tonal
 * Art Maps, §6.1, as lists. It is made again only when the strokes' size or direction changes. */
#ifndef HATCH_SEED_COVERAGE_H
#define HATCH_SEED_COVERAGE_H

#include "seed/seeds.h"

/* A stroke in the plane that the tile repeats over: that of a seed, so many tiles away. */
struct hatch_coverage_copy {
    uint32_t seed;
    int32_t tile_u, tile_v;
};

/* Texel (x, y) of side by side covers [x, x + 1) by [y, y + 1) over side; the strokes that may reach into it are
 * copies[first[y * side + x]] .. copies[first[y * side + x + 1] - 1], their seeds rising. */
struct hatch_coverage {
    uint32_t side;
    uint32_t *first; /* side * side + 1 */
    struct hatch_coverage_copy *copies;
};

/* length, width: of a stroke, as fractions of the tile, of any size; its middle stands on the seed, and it
 * lies at (cosine, sine) to u. */
struct hatch_coverage_stroke {
    double length, width, cosine, sine;
};

/* side: 1 .. 1024. A stroke is listed where its rectangle and the texel's meet, and nowhere else. */
enum hatch_status hatch_coverage_make(const struct hatch_seed_place *places, uint32_t count,
                                      const struct hatch_coverage_stroke *stroke, uint32_t side,
                                      struct hatch_arena *arena, struct hatch_coverage *coverage,
                                      struct hatch_err *err) HATCH_MUST_USE;

#endif
