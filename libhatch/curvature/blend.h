/* Private to the curvature: the weighted mean of the fits that cover a point (partition of unity). */
#ifndef HATCH_CURVATURE_BLEND_H
#define HATCH_CURVATURE_BLEND_H

#include <stdbool.h>

#include "curvature/tensor.h"

struct hatch_curvature_blend {
    /* Weighted sums over the fits, and the sum of the weights. */
    struct hatch_curvature_tensor tensor;
    struct hatch_curvature_variance variance;
    double radius, weight;
    /* Smallest expected squared error of a fit: over all levels, and on the current one; INFINITY: no fit. */
    double best_error, level_error;
    bool open; /* whether larger supports may help */
};

/* Returns the weight of a fit of an expected squared error. */
double hatch_curvature_blend_weight(double error);

/* Adds a fit.
 *   side  1, or -1 where the fit's outside is not that of the point */
void hatch_curvature_blend_add(struct hatch_curvature_blend *blend, double weight, double side,
                               const struct hatch_curvature_tensor *tensor,
                               const struct hatch_curvature_variance *variance, double radius);

/* Computes the weighted means. Returns false when the blend has no fit. */
bool hatch_curvature_blend_mean(const struct hatch_curvature_blend *blend, struct hatch_curvature_tensor *tensor,
                                struct hatch_curvature_variance *variance);

/* Returns whether the standard error of the direction is at most limit_rad. */
bool hatch_curvature_blend_is_certain(const struct hatch_curvature_blend *blend, double limit_rad);

#endif
