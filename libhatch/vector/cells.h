/* Square cells over the plane, for finding what is near. */
#ifndef HATCH_VECTOR_CELLS_H
#define HATCH_VECTOR_CELLS_H

#include "vector/paths.h"

struct hatch_vector_cells {
    double low[2], side;
    uint32_t columns, rows;
};

/* Chooses cells that cover some points.
 *   points      2 per point; finite
 *   cell_count  about how many cells, at least 1; there are fewer where sides would be less than least_side
 *   least_side  over 0 */
struct hatch_vector_cells hatch_vector_cells_over(const double *points, size_t point_count, double cell_count,
                                                  double least_side);

/* Returns the column (axis 0) or row (axis 1) of a coordinate; outside the cells, the nearest one. */
uint32_t hatch_vector_cell(const struct hatch_vector_cells *cells, int axis, double at);

/* Returns the number of points of all paths. */
size_t hatch_vector_point_count(const struct hatch_vector_paths *paths);

#endif
