/* The strokes of a tonal art map with ids (tamgen --ids), read back from its texels. A texel names one stroke, the one
 * drawn first; where a stroke lies under others, its curve tells where it goes on. A stroke that no texel names is
 * known from the list of strokes in the file, if there is one. */
#ifndef HATCH_COVER_STROKES_H
#define HATCH_COVER_STROKES_H

#include <stdbool.h>

#include "fit/cubic.h"
#include "stroke/stroke.h"
#include "tam/tam.h"

#define HATCH_COVER_ID_MAX ((1u << 24) - 1) /* greatest id: channels are floats, which hold greater ones with gaps */

/* The stroke that a texel names. */
struct hatch_cover_owner {
    uint32_t id;     /* 0: none */
    uint32_t column; /* the first one in which it is named */
    float t;         /* along the stroke, 0 .. 1 */
    float ink;       /* of the texel in that column: 1 - reflectance */
};

/* A stroke. */
struct hatch_cover_stroke {
    struct hatch_cubic curve; /* in texels of the finest level */
    float shift[2];           /* added to the curve, this puts its middle into the tile, 0 .. size_px */
    float length;             /* of the whole stroke, in the same texels */
    bool is_there;
    uint32_t texel_count;                /* texels of the finest level that name it */
    uint32_t column;                     /* the first one in which it is named */
    const struct hatch_stroke *original; /* in the list; NULL: it is not listed */
};

/* The texels of a level by their strokes: those of stroke id are at[first[id]] .. at[first[id + 1] - 1], ascending. */
struct hatch_cover_texels {
    uint32_t *first; /* id_max + 2 entries */
    uint32_t *at;    /* y * size + x */
};

/* Finds the owners of a level's texels.
 *   tam     with ids
 *   level   a drawn one
 *   owners  out: one per texel
 * Returns the greatest id. */
uint32_t hatch_cover_find_owners(const struct hatch_tam *tam, uint32_t level, struct hatch_cover_owner *owners);

/* Groups the texels of a level by their strokes.
 *   owners  texel_count of them
 *   texels  out, in arena */
enum hatch_status hatch_cover_group(const struct hatch_cover_owner *owners, uint32_t texel_count, uint32_t id_max,
                                    struct hatch_arena *arena, struct hatch_cover_texels *texels,
                                    struct hatch_err *err) HATCH_MUST_USE;

/* Fits a curve to each stroke. Texels are unwrapped along the stroke, which may cross the border of the tile.
 *   owners, texels  of the finest level
 *   strokes         out: id_max + 1 of them, by id */
enum hatch_status hatch_cover_fit_strokes(const struct hatch_tam *tam, const struct hatch_cover_owner *owners,
                                          const struct hatch_cover_texels *texels, uint32_t id_max,
                                          struct hatch_arena *scratch, struct hatch_cover_stroke *strokes,
                                          struct hatch_err *err) HATCH_MUST_USE;

/* Takes the curves of strokes that no texel names from the list of strokes.
 *   size_px  of the finest level
 *   strokes  in, out: id_max + 1 of them, by id */
void hatch_cover_add_listed(const struct hatch_stroke_list *list, uint32_t size_px, uint32_t id_max,
                            struct hatch_cover_stroke *strokes);

/* Computes the place of a stroke at t, in texels of the finest level; its middle is in the tile. */
void hatch_cover_stroke_at(const struct hatch_cover_stroke *stroke, float t, float place[2]);

#endif
