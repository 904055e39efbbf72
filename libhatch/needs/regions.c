#include "needs/regions.h"

#include <math.h>
#include <string.h>

/* Cells that a box touches, first and last along each axis. */
struct range {
    uint32_t first[3], last[3];
};

static uint32_t cell_of(const struct hatch_needs_regions *regions, int axis, double at)
{
    double place = regions->side[axis] > 0 ? floor((at - regions->low[axis]) / regions->side[axis]) : 0;
    return (uint32_t)fmin(fmax(place, 0), HATCH_NEEDS_SIDE - 1);
}

static struct range range_of(const struct hatch_needs_regions *regions, const double corners[3][3])
{
    struct range range;
    for (int k = 0; k < 3; k++) {
        double low = fmin(fmin(corners[0][k], corners[1][k]), corners[2][k]);
        double high = fmax(fmax(corners[0][k], corners[1][k]), corners[2][k]);
        range.first[k] = cell_of(regions, k, low);
        range.last[k] = cell_of(regions, k, high);
    }
    return range;
}

static uint32_t index_of(uint32_t x, uint32_t y, uint32_t z)
{
    return (z * HATCH_NEEDS_SIDE + y) * HATCH_NEEDS_SIDE + x;
}

void hatch_needs_raise(struct hatch_needs_regions *regions, const double corners[3][3], double px)
{
    const struct range range = range_of(regions, corners);
    for (uint32_t z = range.first[2]; z <= range.last[2]; z++)
        for (uint32_t y = range.first[1]; y <= range.last[1]; y++)
            for (uint32_t x = range.first[0]; x <= range.last[0]; x++) {
                float *cell = &regions->px[index_of(x, y, z)];
                *cell = fmaxf(*cell, (float)px);
            }
}

double hatch_needs_px(const struct hatch_needs_regions *regions, const double corners[3][3])
{
    const struct range range = range_of(regions, corners);
    float most = 0;
    for (uint32_t z = range.first[2]; z <= range.last[2]; z++)
        for (uint32_t y = range.first[1]; y <= range.last[1]; y++)
            for (uint32_t x = range.first[0]; x <= range.last[0]; x++)
                most = fmaxf(most, regions->px[index_of(x, y, z)]);
    return (double)most;
}

/* Writes the largest of each cell and its two neighbours along an axis.
 *   step  from a cell to the next along the axis */
static void spread_along(const float *from, uint32_t step, float *to)
{
    for (uint32_t i = 0; i < HATCH_NEEDS_CELLS; i++) {
        uint32_t at = i / step % HATCH_NEEDS_SIDE;
        float before = at > 0 ? from[i - step] : 0, after = at + 1 < HATCH_NEEDS_SIDE ? from[i + step] : 0;
        to[i] = fmaxf(from[i], fmaxf(before, after));
    }
}

void hatch_needs_spread(struct hatch_needs_regions *regions, float *work)
{
    spread_along(regions->px, 1, work);
    spread_along(work, HATCH_NEEDS_SIDE, regions->px);
    spread_along(regions->px, HATCH_NEEDS_SIDE * HATCH_NEEDS_SIDE, work);
    memcpy(regions->px, work, HATCH_NEEDS_CELLS * sizeof *work);
}
