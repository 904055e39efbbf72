/* Which strokes may cover a place in the tile: the stroke coverage texture of Recursive Procedural Tonal
 * Art Maps, §6.1, as lists. It is made again only when the strokes' size or direction changes. */
#ifndef HATCH_SEED_COVERAGE_H
#define HATCH_SEED_COVERAGE_H

#include "seed/seeds.h"

/* Texel (x, y) of side by side covers [x, x + 1) by [y, y + 1) over side; its seeds are
 * ids[first[y * side + x]] .. ids[first[y * side + x + 1] - 1], rising. */
struct hatch_coverage {
    uint32_t side;
    uint32_t *first; /* side * side + 1 */
    uint32_t *ids;
};

/* length, width: of a stroke at its largest, as fractions of the tile; its middle stands on the seed, and
 * it lies at (cosine, sine) to u. What of it is more than half a tile from its seed along u or v is
 * not drawn and not listed. side: 1 .. 1024. */
struct hatch_coverage_stroke {
    double length, width, cosine, sine;
};

/* Where a row at v across from a stroke's middle may be within `reach` of the stroke: span[0] .. span[1]
 * along u, both within -limit .. limit. False where nowhere. */
bool hatch_coverage_span(const struct hatch_coverage_stroke *stroke, double v, double reach, double limit,
                         double span[2]);

enum hatch_status hatch_coverage_make(const struct hatch_seed_place *places, uint32_t count,
                                      const struct hatch_coverage_stroke *stroke, uint32_t side,
                                      struct hatch_arena *arena, struct hatch_arena *scratch,
                                      struct hatch_coverage *coverage, struct hatch_err *err)
    HATCH_MUST_USE;

#endif
