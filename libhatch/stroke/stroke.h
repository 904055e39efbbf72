/* A stroke: a line, an arc or a drawn path on the unit torus (the tile), drawn at one pixel width on every
 * level of a tonal art map (Praun et al. 2001, §3). */
#ifndef HATCH_STROKE_STROKE_H
#define HATCH_STROKE_STROKE_H

#include <math.h>
#include <stdint.h>

#include "base/arena.h"

#define HATCH_STROKE_LEVELS_MAX 8u
#define HATCH_STROKE_BEND_MAX 6.25f /* nearly a full turn */

struct hatch_path;

struct hatch_stroke {
    float x, y;            /* its middle, fractions of the tile, [0, 1); y downwards */
    float length;          /* along it, fraction of the tile, >= 0; 0 is a dot */
    float angle_rad;       /* from +x towards +y, in its middle; of a path, of its chord */
    float bend_rad;        /* how far it turns from start to end, towards +y where it runs along +x; 0 is straight;
                              -HATCH_STROKE_BEND_MAX .. HATCH_STROKE_BEND_MAX, with path NULL */
    float width_px;        /* > 0 */
    float tone;            /* 0 .. 1: how dark the ink is; scales the brush's alpha */
    float rgb[3];          /* linear colour of the ink, 0 .. 1; black is the default */
    uint32_t id;           /* 1 upwards, in drawing order */
    uint32_t column;       /* first tone column that holds it, 0 the lightest */
    uint32_t level;        /* coarsest level that holds it, counted from the finest (0) upwards */
    uint32_t texture_seed; /* varies the brush's grain from stroke to stroke */
    uint8_t delay[HATCH_STROKE_LEVELS_MAX]; /* columns by which a level holds it later than `column`; does not
                                               fall with the level; 0 beyond `level` */
    const struct hatch_path *path;          /* around (x, y), or NULL; not owned */
};

/* The same place of the tile, in [0, 1), as the fraction x of its side, which may lie outside. */
static inline float hatch_stroke_wrap(double x)
{
    float wrapped = (float)(x - floor(x));
    return wrapped < 1 ? wrapped : 0;
}

/* A growing list in an arena, in drawing order. */
struct hatch_stroke_list {
    struct hatch_stroke *items;
    uint32_t count, capacity;
};

/* Adds a copy of the stroke; the list begins as {0} and doubles in arena. Its path is not copied. */
enum hatch_status hatch_stroke_list_add(struct hatch_stroke_list *list, struct hatch_arena *arena,
                                        const struct hatch_stroke *stroke, struct hatch_err *err) HATCH_MUST_USE;

#endif
