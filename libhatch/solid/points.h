/* Points in a cube that repeats along each axis. */
#ifndef HATCH_SOLID_POINTS_H
#define HATCH_SOLID_POINTS_H

#include "base/parallel.h"
#include "base/progress.h"

/* Points sorted into cells. */
struct hatch_solid_points {
    uint32_t count;
    uint32_t cells;  /* along a side */
    uint32_t *first; /* per cell [(z * cells + y) * cells + x], its first point; cells^3 + 1 entries */
    float (*at)[3];  /* positions, 0 .. 1, by cell */
    float *factors;  /* of the distance from each point, by cell */
    float factor_min;
    uint32_t *numbers; /* of each point in the order in which the points were made */
};

/* Makes one point in each of side^3 cells.
 *   jitter  0: in the middle of the cell; 1: anywhere in it
 *   points  out, in arena; factors are 1 */
enum hatch_status hatch_solid_points_jitter(uint32_t side, float jitter, uint64_t seed, struct hatch_arena *arena,
                                            struct hatch_solid_points *points, struct hatch_err *err) HATCH_MUST_USE;

/* Makes points that keep away from each other: an additive recurrence, whose first points are about as well spread as
 * all of them, then rounds in which near points repel each other.
 *   count     1 .. 2^26
 *   vary      factors are random in 1 - vary / 2 .. 1 + vary / 2
 *   progress  may be NULL
 *   points    out, in arena */
enum hatch_status hatch_solid_points_spread(uint32_t count, float vary, uint64_t seed, struct hatch_pool *pool,
                                            const struct hatch_progress *progress, struct hatch_arena *arena,
                                            struct hatch_arena *scratch, struct hatch_solid_points *points,
                                            struct hatch_err *err) HATCH_MUST_USE;

#define HATCH_SOLID_POINT_BYTES 36u /* that each takes, with its cell, while they are made */

/* Finds the two smallest distances from a place to points and their copies in the cubes around, each times the factor
 * of its point.
 *   at  0 .. 1 along each axis */
void hatch_solid_points_nearest(const struct hatch_solid_points *points, const float at[3], float distances[2]);

/* Returns the cell of a coordinate in 0 .. 1. */
static inline uint32_t hatch_solid_cell(float coordinate, uint32_t cells)
{
    uint32_t cell = (uint32_t)(coordinate * (float)cells);
    return cell < cells ? cell : cells - 1;
}

#endif
