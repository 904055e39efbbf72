#include <math.h>

#include "lapped/work.h"

/* Number of obstacle points along a segment. */
#define POINTS_PER_SIDE 4
/* Offsets that are tried: numbers of directions on half a turn and of distances. */
#define DIRECTIONS 8
#define DISTANCES 5

enum hatch_status hatch_obstacles_add(struct hatch_obstacles *obstacles, const double a[2], const double b[2],
                                      struct hatch_err *err)
{
    void *array = obstacles->xy;
    HATCH_TRY(hatch_lapped_reserve(obstacles->arena, &array, &obstacles->capacity,
                                   2 * (obstacles->count + POINTS_PER_SIDE), sizeof *obstacles->xy, err));
    obstacles->xy = array;
    for (int i = 0; i < POINTS_PER_SIDE; i++, obstacles->count++) {
        double t = (double)i / (POINTS_PER_SIDE - 1);
        for (uint32_t k = 0; k < 2; k++)
            obstacles->xy[2 * obstacles->count + k] = a[k] + t * (b[k] - a[k]);
    }
    return HATCH_OK;
}

double hatch_patch_radius_min(const struct hatch_patch *patch, const struct hatch_outline *outline)
{
    double away = sqrt(patch->offset[0] * patch->offset[0] + patch->offset[1] * patch->offset[1]);
    return (patch->seed_radius + away) / (2 * outline->core_min);
}

/* Returns the largest radius, up to the patch's, at which an outline around center contains no obstacle; 0 if it is not
 * greater than `least`.
 *   nearest  in: obstacle to test first; out: obstacle that limits the radius, which probably also limits it at the
 *            next center */
static double largest_radius(const struct hatch_patch *patch, const struct hatch_outline *outline,
                             const struct hatch_obstacles *obstacles, const double center[2], double least,
                             uint32_t *nearest)
{
    double reach = 2 * outline->reach_max, squared = reach * patch->radius * reach * patch->radius;
    double enough = reach * least * reach * least;
    for (uint32_t n = 0, i = *nearest; n < obstacles->count; n++, i = i + 1 < obstacles->count ? i + 1 : 0) {
        double x = obstacles->xy[2 * i] - center[0], y = obstacles->xy[2 * i + 1] - center[1];
        double away = x * x + y * y;
        if (away >= squared)
            continue;
        squared = away;
        *nearest = i;
        if (squared <= enough)
            return 0;
    }
    return sqrt(squared) / reach;
}

void hatch_patch_avoid_obstacles(struct hatch_patch *patch, const struct hatch_outline *outline,
                                 const struct hatch_obstacles *obstacles, double radius_min)
{
    double middle[2] = {patch->center[0] - patch->offset[0], patch->center[1] - patch->offset[1]};
    double offset_max = fmax(0, 2 * outline->core_min * patch->radius - patch->seed_radius);
    double best = radius_min / 1.001, offset[2] = {0, 0};
    uint32_t nearest = 0;
    for (int i = 0; i <= 2 * DIRECTIONS * DISTANCES; i++) {
        double t = (double)((i - 1) % DIRECTIONS) * 2 / DIRECTIONS - 1, side = (i - 1) / DIRECTIONS % 2 ? -1 : 1;
        double away = i == 0 ? 0 : offset_max * ((i - 1) / (2 * DIRECTIONS) + 1) / DISTANCES;
        double x = side * away * (1 - t * t) / (1 + t * t), y = side * away * 2 * t / (1 + t * t);
        double center[2] = {middle[0] + x, middle[1] + y};
        double least = fmax(best * 1.001, (patch->seed_radius + away) / (2 * outline->core_min));
        double radius = largest_radius(patch, outline, obstacles, center, least, &nearest);
        if (radius > least) {
            best = radius;
            offset[0] = x;
            offset[1] = y;
        }
    }
    patch->offset[0] = offset[0];
    patch->offset[1] = offset[1];
    patch->radius = fmax(best, hatch_patch_radius_min(patch, outline));
}
