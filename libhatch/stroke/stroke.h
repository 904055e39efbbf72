/* Strokes: lines, arcs or drawn paths on the unit torus (the tile), drawn with the same width in pixels on every level
 * of a tonal art map (Praun et al. 2001, §3). */
#ifndef HATCH_STROKE_STROKE_H
#define HATCH_STROKE_STROKE_H

#include <math.h>
#include <stdint.h>

#include "base/arena.h"

#define HATCH_STROKE_LEVELS_MAX 8u
#define HATCH_STROKE_BEND_MAX 6.25f /* radians; nearly a full turn */

struct hatch_path;

struct hatch_stroke {
    float x, y;            /* middle, fractions of the tile, [0, 1); y downwards */
    float length;          /* arc length, fraction of the tile, 0 upwards; 0 is a dot */
    float angle_rad;       /* direction in the middle, from +x towards +y; for a path, that of its chord */
    float bend_rad;        /* turn from start to end, positive from +x towards +y, -HATCH_STROKE_BEND_MAX ..
                              HATCH_STROKE_BEND_MAX; 0 if straight or if there is a path */
    float width_px;        /* greater than 0 */
    float tone;            /* opacity of the ink, 0 .. 1; scales the brush's alpha */
    float rgb[3];          /* colour of the ink, linear, 0 .. 1; default black */
    uint32_t id;           /* 1 upwards, in drawing order */
    uint32_t column;       /* first column that holds it */
    uint32_t level;        /* coarsest level that holds it */
    uint32_t texture_seed; /* random seed of the brush's grain */
    uint8_t delay[HATCH_STROKE_LEVELS_MAX]; /* per level: number of columns from `column` to the first one that holds it
                                               on that level; non-decreasing; 0 beyond `level` */
    const struct hatch_path *path;          /* points relative to (x, y), not owned; NULL: a line or an arc */
};

/* Wraps a coordinate, in tiles, to [0, 1). */
static inline float hatch_stroke_wrap(double x)
{
    float wrapped = (float)(x - floor(x));
    return wrapped < 1 ? wrapped : 0;
}

/* A growing list in an arena, in drawing order; initialise with {0}. */
struct hatch_stroke_list {
    struct hatch_stroke *items;
    uint32_t count, capacity;
};

/* Appends a copy of the stroke; its path is kept by reference. The array of the list doubles in arena as it grows. */
enum hatch_status hatch_stroke_list_add(struct hatch_stroke_list *list, struct hatch_arena *arena,
                                        const struct hatch_stroke *stroke, struct hatch_err *err) HATCH_MUST_USE;

#endif
