#include "curvature/place.h"

#include "math/vector.h"

/* More than inverse variance: errors of fits that share points are alike, and the better ones should speak nearly
 * alone. */
double hatch_place_weight(double error)
{
    return 1 / (error * sqrt(error));
}

void hatch_place_add(struct hatch_place *place, double weight, double side, const struct hatch_bend *bend,
                     const struct hatch_bend_variance *variance, double radius)
{
    for (int i = 0; i < 6; i++)
        place->bend.matrix[i] += side * weight * bend->matrix[i];
    for (int i = 0; i < 3; i++)
        place->bend.normal[i] += side * weight * bend->normal[i];
    place->weight += weight;
    place->variance.across += weight * variance->across;
    place->variance.mean += weight * variance->mean;
    place->radius += weight * radius;
}

bool hatch_place_mean(const struct hatch_place *place, struct hatch_bend *bend, struct hatch_bend_variance *variance)
{
    if (!(place->weight > 0))
        return false;
    for (int i = 0; i < 6; i++)
        bend->matrix[i] = place->bend.matrix[i] / place->weight;
    hatch_vec_copy(place->bend.normal, bend->normal);
    variance->across = place->variance.across / place->weight;
    variance->mean = place->variance.mean / place->weight;
    return hatch_vec_normalize(bend->normal) > 0;
}

/* What is far from known shows in the curvatures' difference alone, squared: twice the sum of a matrix' squares less
 * the square of its trace. */
bool hatch_place_known(const struct hatch_place *place, double limit_rad)
{
    const double *m = place->bend.matrix;
    double trace = m[0] + m[3] + m[5], off = m[1] * m[1] + m[2] * m[2] + m[4] * m[4];
    double spread = 2 * (m[0] * m[0] + m[3] * m[3] + m[5] * m[5] + 2 * off) - trace * trace;
    if (place->variance.across * place->weight > 2 * limit_rad * limit_rad * spread)
        return false;
    struct hatch_bend bend;
    struct hatch_bend_variance variance;
    struct hatch_principal principal;
    if (!hatch_place_mean(place, &bend, &variance))
        return false;
    hatch_bend_principal(&bend, &principal);
    return hatch_bend_deviation(&principal, &variance) <= limit_rad;
}
