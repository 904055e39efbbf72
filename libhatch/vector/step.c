#include "vector/step.h"

#include <math.h>

/* Distances from a line at which the surface beyond it is looked at: these, and twice these. In narrow folds the
 * surface is steep, and takes all of the step from what is seen at the farther ones. A line may lie up to a pixel
 * beside the edge, and nothing is beyond it yet at the nearer ones. */
#define NEAR_PX 0.6
#define FAR_PX 1.25

#define CLIFF 25.6 /* least slope, in depth per distance in the picture, that is another step */

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

/* Returns the step as seen at a distance from the line, and at twice that distance. */
static double step_at(const struct hatch_occluders *occluders, const double at_px[2], const double away[2],
                      double depth, double reach_px)
{
    double pixel = (occluders->view.orthographic ? 1 : depth) / occluders->focal_px[1], at[2], beyond[2];
    for (int i = 0; i < 2; i++) {
        for (int k = 0; k < 2; k++)
            at[k] = at_px[k] + (i + 1) * reach_px * away[k];
        beyond[i] = (hatch_occluders_depth(occluders, at) - depth) / pixel;
    }
    double slope = beyond[1] - beyond[0] < CLIFF * reach_px ? fmax(beyond[1] - beyond[0], 0) : 0;
    return beyond[0] - slope;
}

double hatch_occluders_step(const struct hatch_occluders *occluders, const double at_px[2], const double away[2],
                            double depth)
{
    return fmax(step_at(occluders, at_px, away, depth, NEAR_PX), step_at(occluders, at_px, away, depth, FAR_PX));
}
