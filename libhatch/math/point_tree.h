/* Finds the nearest of many points, in a number of steps that grows with its logarithm. */
#ifndef HATCH_MATH_POINT_TREE_H
#define HATCH_MATH_POINT_TREE_H

#include <stdint.h>

#include "base/arena.h"

#define HATCH_POINT_NONE UINT32_MAX

/* A k-d tree. The point in the middle of a range divides it along an axis: those before it are no higher, those after
 * it no lower. */
struct hatch_point_tree {
    const double *points; /* 3 per point */
    uint32_t count;
    struct hatch_point_tree_item {
        double key; /* coordinate along the axis of the range that was divided last */
        uint32_t point;
    } * items;
    uint8_t *axis; /* per item: axis of the range in whose middle it is */
};

/* Makes the tree of points in arena.
 *   points  3 per point, finite; kept by reference */
enum hatch_status hatch_point_tree_make(const double *points, uint32_t count, struct hatch_arena *arena,
                                        struct hatch_point_tree *tree, struct hatch_err *err) HATCH_MUST_USE;

/* Returns the distance of a point: at least that from the position of the search, apart from rounding. */
typedef double (*hatch_point_distance)(const void *context, uint32_t point);

/* Returns the point of the least distance; of equally near ones the one with the lowest number. HATCH_POINT_NONE when
 * there are no points, or none at a distance that is a number. */
uint32_t hatch_point_tree_nearest(const struct hatch_point_tree *tree, const double position[3],
                                  hatch_point_distance distance, const void *context);

#endif
