/* Finds the visible parts of straight segments: cuts them where sides of occluders cross them in the picture, and where
 * they pass through an occluder. */
#ifndef HATCH_VECTOR_SIGHT_H
#define HATCH_VECTOR_SIGHT_H

#include "vector/occluders.h"

/* A segment inside the picture. */
struct hatch_sight_line {
    double at[2][2];   /* its ends, in pixels */
    double limit[2];   /* nearness at its ends: nearer occluders hide it */
    double reach_px;   /* the segment is visible where it would be if it were moved sideways by up to this much */
    uint32_t faces[2]; /* the face that each end lies on, as in hatch_occluders_face; HATCH_NONE: on none */
};

/* The visible parts of the last segment. */
struct hatch_sight {
    const struct hatch_occluders *occluders;
    struct hatch_arena *arena;
    uint32_t count, room;
    double (*parts)[2]; /* begin and end of each, 0 .. 1 along the segment in the picture, ascending */
    double (*open)[2];  /* private: parts of a cell that are not hidden yet */
};

/* Allocates the work of a thread.
 *   occluders  kept by reference
 *   arena      for the work, which may grow in it */
enum hatch_status hatch_sight_make(const struct hatch_occluders *occluders, struct hatch_arena *arena,
                                   struct hatch_sight *sight, struct hatch_err *err) HATCH_MUST_USE;

/* Finds the visible parts of a segment. The faces that its ends lie on do not hide it, nor do faces that have a corner
 * in common with one of them and face the same way: such a face is beside it in the picture. */
enum hatch_status hatch_sight_find(struct hatch_sight *sight, const struct hatch_sight_line *line,
                                   struct hatch_err *err) HATCH_MUST_USE;

#endif
