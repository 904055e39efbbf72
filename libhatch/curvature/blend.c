#include "curvature/blend.h"

#include "math/vector.h"

/* Steeper than inverse variance: fits that share points have correlated errors, so the best should dominate. */
double hatch_curvature_blend_weight(double error)
{
    return 1 / (error * sqrt(error));
}

void hatch_curvature_blend_add(struct hatch_curvature_blend *blend, double weight, double side,
                               const struct hatch_curvature_tensor *tensor,
                               const struct hatch_curvature_variance *variance, double radius)
{
    for (int i = 0; i < 6; i++)
        blend->tensor.matrix[i] += side * weight * tensor->matrix[i];
    for (int i = 0; i < 3; i++)
        blend->tensor.normal[i] += side * weight * tensor->normal[i];
    blend->weight += weight;
    blend->variance.off_diagonal += weight * variance->off_diagonal;
    blend->variance.mean += weight * variance->mean;
    blend->radius += weight * radius;
}

bool hatch_curvature_blend_mean(const struct hatch_curvature_blend *blend, struct hatch_curvature_tensor *tensor,
                                struct hatch_curvature_variance *variance)
{
    if (!(blend->weight > 0))
        return false;
    for (int i = 0; i < 6; i++)
        tensor->matrix[i] = blend->tensor.matrix[i] / blend->weight;
    hatch_vec_copy(blend->tensor.normal, tensor->normal);
    variance->off_diagonal = blend->variance.off_diagonal / blend->weight;
    variance->mean = blend->variance.mean / blend->weight;
    return hatch_vec_normalize(tensor->normal) > 0;
}

/* Rejects clear cases early by the squared difference of the curvatures: twice the sum of the squares of the matrix,
 * less the square of its trace. */
bool hatch_curvature_blend_is_certain(const struct hatch_curvature_blend *blend, double limit_rad)
{
    const double *m = blend->tensor.matrix;
    double trace = m[0] + m[3] + m[5], off_diagonal = m[1] * m[1] + m[2] * m[2] + m[4] * m[4];
    double difference = 2 * (m[0] * m[0] + m[3] * m[3] + m[5] * m[5] + 2 * off_diagonal) - trace * trace;
    if (blend->variance.off_diagonal * blend->weight > 2 * limit_rad * limit_rad * difference)
        return false;
    struct hatch_curvature_tensor tensor;
    struct hatch_curvature_variance variance;
    struct hatch_principal_curvatures principal;
    if (!hatch_curvature_blend_mean(blend, &tensor, &variance))
        return false;
    hatch_curvature_tensor_principal(&tensor, &principal);
    return hatch_curvature_direction_error(&principal, &variance) <= limit_rad;
}
