/* For each texel of a tonal art map with ids, the strokes that cover it: the texel's own one, and those that lie below
 * it. Where strokes cross, none of them has a gap. */
#ifndef HATCH_COVER_COVER_H
#define HATCH_COVER_COVER_H

#include "stroke/stroke.h"
#include "tam/tam.h"

/* Members of a mark: shift and width in its bits, and in its id. */
#define HATCH_COVER_MARK_T_BITS 12u       /* from bit 0: along the stroke, 0 .. 1 */
#define HATCH_COVER_MARK_COVER_SHIFT 12u  /* 8 bits: share of the texel that the stroke covers, 0 .. 1 */
#define HATCH_COVER_MARK_COLUMN_SHIFT 20u /* 8 bits: first column in which it does */
#define HATCH_COVER_MARK_TILE_SHIFT 28u   /* 4 bits: the lower ones of hatch_cover_mark_tile */
#define HATCH_COVER_MARK_LAYER_SHIFT 24u  /* of an id: 6 bits above it are the stroke's first column, at most 63 */
#define HATCH_COVER_MARK_HIGH_SHIFT 30u   /* of an id: 2 bits: the upper ones of hatch_cover_mark_tile */
#define HATCH_COVER_TILES 3               /* farthest tile of a stroke's middle along u or v; others are not listed */

/* A stroke that covers a texel. */
struct hatch_cover_mark {
    uint32_t id; /* of the stroke, its layer, and a part of its tile */
    uint32_t bits;
};

/* Returns the tile of the stroke's middle as seen from the texel's tile: 3 bits each for u and v, counted from
 * -HATCH_COVER_TILES. */
static inline uint32_t hatch_cover_mark_tile(const struct hatch_cover_mark *mark)
{
    return mark->bits >> HATCH_COVER_MARK_TILE_SHIFT | mark->id >> HATCH_COVER_MARK_HIGH_SHIFT << 4;
}

/* The marks of texel i of a level are marks[ends[k]] .. marks[ends[k + 1] - 1], where k = first[level] + i, by
 * ascending id. */
struct hatch_cover {
    uint32_t levels;
    uint32_t first[HATCH_MIP_LEVELS_MAX];
    uint32_t texel_count, mark_count; /* of all levels together */
    uint32_t *ends;                   /* texel_count + 1 entries */
    struct hatch_cover_mark *marks;
    float width_px; /* mean width of strokes where they are widest, in texels */
    float ink;      /* darkness of a stroke, 0 .. 1; the shares that strokes cover are relative to it */
};

/* Lists the strokes of all texels of the drawn levels.
 *   tam      with ids
 *   strokes  of the map, with their ids; without them, those under which nothing of the paper was left are missing
 *   cover    out, in arena
 * HATCH_BAD_INPUT for ids far greater than the number of texels; HATCH_LIMIT when memory does not suffice. */
enum hatch_status hatch_cover_make(const struct hatch_tam *tam, const struct hatch_stroke_list *strokes,
                                   struct hatch_arena *arena, struct hatch_arena *scratch, struct hatch_cover *cover,
                                   struct hatch_err *err) HATCH_MUST_USE;

#endif
