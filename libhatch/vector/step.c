#include "vector/step.h"

#include <math.h>

#define REACH_PX 1.25 /* distances at which the surface beyond a line is looked at: this, and twice this */
#define STEP_PX 4.0   /* least step in depth */
#define CLIFF 8.0     /* least steps in depth, over REACH_PX, that are another step and no slope */

const struct hatch_occluder *hatch_occluders_find(const struct hatch_occluders *occluders, const double at_px[2],
                                                  double *depth)
{
    const struct hatch_occluder *found = NULL;
    double nearest = occluders->view.orthographic ? -HUGE_VAL : 0;
    *depth = HUGE_VAL;
    if (!(at_px[0] >= 0 && at_px[1] >= 0 && at_px[0] <= occluders->width_px && at_px[1] <= occluders->height_px))
        return NULL;
    uint32_t cell = hatch_vector_cell(&occluders->cells, 1, at_px[1]) * occluders->cells.columns +
                    hatch_vector_cell(&occluders->cells, 0, at_px[0]);
    for (uint32_t i = occluders->first[cell]; i < occluders->first[cell + 1]; i++) {
        const struct hatch_occluder *occluder = &occluders->at[occluders->listed[i]];
        if (occluder->nearest <= nearest)
            break;
        if (!(hatch_occluder_value(occluder->sides[0], at_px) >= 0 &&
              hatch_occluder_value(occluder->sides[1], at_px) >= 0 &&
              hatch_occluder_value(occluder->sides[2], at_px) >= 0))
            continue;
        double nearness = hatch_occluder_value(occluder->nearness, at_px);
        if (nearness <= nearest || nearness > occluders->nearest)
            continue;
        nearest = nearness;
        found = occluder;
    }
    if (found)
        *depth = occluders->view.orthographic ? -nearest : 1 / nearest;
    return found;
}

double hatch_occluders_depth(const struct hatch_occluders *occluders, const double at_px[2])
{
    double depth;
    hatch_occluders_find(occluders, at_px, &depth);
    return depth;
}

bool hatch_occluders_step(const struct hatch_occluders *occluders, const double at_px[2], const double away[2],
                          double depth)
{
    double step = STEP_PX * (occluders->view.orthographic ? 1 : depth) / occluders->focal_px[1], at[2], beyond[2];
    for (int i = 0; i < 2; i++) {
        for (int k = 0; k < 2; k++)
            at[k] = at_px[k] + (i + 1) * REACH_PX * away[k];
        beyond[i] = hatch_occluders_depth(occluders, at);
    }
    double slope = beyond[1] - beyond[0] < CLIFF * step ? fmax(beyond[1] - beyond[0], 0) : 0;
    return beyond[0] - slope > depth + step;
}
