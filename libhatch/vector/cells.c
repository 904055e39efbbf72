#include "vector/cells.h"

#include <math.h>

struct hatch_vector_cells hatch_vector_cells_over(const double *points, size_t point_count, double cell_count,
                                                  double least_side)
{
    struct hatch_vector_cells cells = {.columns = 1, .rows = 1};
    double size[2];
    for (int k = 0; k < 2; k++) {
        double low = INFINITY, high = -INFINITY;
        for (size_t i = 0; i < point_count; i++) {
            low = fmin(low, points[2 * i + (size_t)k]);
            high = fmax(high, points[2 * i + (size_t)k]);
        }
        cells.low[k] = point_count ? low : 0;
        size[k] = point_count ? high - low : 0;
    }
    cells.side = fmax(sqrt(size[0] * size[1] / cell_count), fmax(size[0], size[1]) / cell_count);
    cells.side = fmax(cells.side, least_side);
    cells.columns = (uint32_t)floor(size[0] / cells.side) + 1;
    cells.rows = (uint32_t)floor(size[1] / cells.side) + 1;
    return cells;
}

uint32_t hatch_vector_cell(const struct hatch_vector_cells *cells, int axis, double at)
{
    uint32_t count = axis ? cells->rows : cells->columns;
    double cell = floor((at - cells->low[axis]) / cells->side);
    return cell < 0 ? 0 : cell < (double)count ? (uint32_t)cell : count - 1;
}

size_t hatch_vector_point_count(const struct hatch_vector_paths *paths)
{
    size_t count = 0;
    for (uint32_t i = 0; i < paths->count; i++)
        count += paths->paths[i].count;
    return count;
}
