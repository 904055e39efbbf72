/* A stroke: a straight line segment with round ends on the unit torus (the tile), drawn at one pixel
 * width on every level of a tonal art map (Praun et al. 2001, §3). */
#ifndef HATCH_STROKE_STROKE_H
#define HATCH_STROKE_STROKE_H

#include <stdint.h>

#include "base/arena.h"

struct hatch_stroke {
    float x, y;        /* centre, fractions of the tile, [0, 1); y downwards */
    float length;      /* fraction of the tile, >= 0; 0 is a dot */
    float angle_rad;   /* from +x towards +y */
    float width_px;    /* > 0 */
    float tone;        /* 0 .. 1: how dark the ink is; scales the brush's alpha */
    float rgb[3];      /* linear colour of the ink, 0 .. 1; black is the default */
    uint32_t id;       /* 1 upwards, in drawing order */
    uint32_t column;   /* first tone column that holds it, 0 the lightest */
    uint32_t level;    /* coarsest level that holds it, counted from the finest (0) upwards */
    uint32_t texture_seed; /* varies the brush's grain from stroke to stroke */
};

/* A growing list in an arena, in drawing order. */
struct hatch_stroke_list {
    struct hatch_stroke *items;
    uint32_t count, capacity;
};

enum hatch_status hatch_stroke_list_add(struct hatch_stroke_list *list, struct hatch_arena *arena,
                                        const struct hatch_stroke *stroke, struct hatch_err *err)
    HATCH_MUST_USE;

#endif
