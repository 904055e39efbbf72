#include <math.h>

#include "lapped/work.h"

/* Places of a side that stand for it. */
#define SIDE_STEPS 4
/* Directions (on half a turn) and distances that are tried. */
#define WAYS 8
#define STEPS 5

enum hatch_status hatch_obstacles_add(struct hatch_obstacles *obstacles, const double a[2], const double b[2],
                                      struct hatch_err *err)
{
    void *array = obstacles->at;
    HATCH_TRY(hatch_heap_reserve(obstacles->arena, &array, &obstacles->room, 2 * (obstacles->count + SIDE_STEPS),
                                 sizeof *obstacles->at, err));
    obstacles->at = array;
    for (int i = 0; i < SIDE_STEPS; i++, obstacles->count++) {
        double t = (double)i / (SIDE_STEPS - 1);
        for (uint32_t k = 0; k < 2; k++)
            obstacles->at[2 * obstacles->count + k] = a[k] + t * (b[k] - a[k]);
    }
    return HATCH_OK;
}

double hatch_patch_least(const struct hatch_patch *patch, const struct hatch_outline *outline)
{
    double away = sqrt(patch->offset[0] * patch->offset[0] + patch->offset[1] * patch->offset[1]);
    return (patch->seed_radius + away) / (2 * outline->core_min);
}

/* The largest radius, up to the patch's, that leaves the obstacles outside when the outline stands there; 0
 * where it is not over `least`. nearest: where the search begins and the obstacle that ended it, which
 * is likely to be in the way of the next place too. */
static double radius_at(const struct hatch_patch *patch, const struct hatch_outline *outline,
                        const struct hatch_obstacles *obstacles, const double center[2], double least,
                        uint32_t *nearest)
{
    double wide = 2 * outline->reach_max, squared = wide * patch->radius * wide * patch->radius;
    double enough = wide * least * wide * least;
    for (uint32_t n = 0, i = *nearest; n < obstacles->count; n++, i = i + 1 < obstacles->count ? i + 1 : 0) {
        double x = obstacles->at[2 * i] - center[0], y = obstacles->at[2 * i + 1] - center[1];
        double away = x * x + y * y;
        if (away >= squared)
            continue;
        squared = away;
        *nearest = i;
        if (squared <= enough)
            return 0;
    }
    return sqrt(squared) / wide;
}

bool hatch_patch_slide(struct hatch_patch *patch, const struct hatch_outline *outline,
                       const struct hatch_obstacles *obstacles, double floor)
{
    double middle[2] = {patch->center[0] - patch->offset[0], patch->center[1] - patch->offset[1]};
    double most = fmax(0, 2 * outline->core_min * patch->radius - patch->seed_radius);
    double best = floor / 1.001, offset[2] = {0, 0};
    uint32_t nearest = 0;
    for (int i = 0; i <= 2 * WAYS * STEPS; i++) {
        double t = (double)((i - 1) % WAYS) * 2 / WAYS - 1, side = (i - 1) / WAYS % 2 ? -1 : 1;
        double away = i == 0 ? 0 : most * ((i - 1) / (2 * WAYS) + 1) / STEPS;
        double x = side * away * (1 - t * t) / (1 + t * t), y = side * away * 2 * t / (1 + t * t);
        double center[2] = {middle[0] + x, middle[1] + y};
        double least = fmax(best * 1.001, (patch->seed_radius + away) / (2 * outline->core_min));
        double radius = radius_at(patch, outline, obstacles, center, least, &nearest);
        if (radius > least) {
            best = radius;
            offset[0] = x;
            offset[1] = y;
        }
    }
    patch->offset[0] = offset[0];
    patch->offset[1] = offset[1];
    patch->radius = fmax(best, hatch_patch_least(patch, outline));
    return best > floor;
}
