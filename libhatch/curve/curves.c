#include "curve/curves.h"

#include <math.h>

#include "math/vector.h"

#define OUTSIDE 1e-3f /* share by which rounding may place a point outside of its face */
#define ROUNDING 1e-6 /* of a coordinate: how far rounding may move a position off its face */
#define FLAT 1e-12    /* square of the sine of a corner's angle under which a face is a line */

void hatch_curve_position(const struct hatch_mesh *mesh, const struct hatch_curve_point *point, float position[3])
{
    const float *data = mesh->attributes[0].data;
    const uint32_t *corners = &mesh->indices[3 * (size_t)point->face];
    const double shares[3] = {1 - (double)point->share[0] - (double)point->share[1], (double)point->share[0],
                              (double)point->share[1]};
    for (int k = 0; k < 3; k++) {
        double sum = 0;
        for (int c = 0; c < 3; c++)
            sum += shares[c] * (double)data[3 * (size_t)corners[c] + (size_t)k];
        position[k] = (float)sum;
    }
}

/* Computes the barycentric coordinates of the place on an edge of a face that is nearest to a position.
 *   c  number of the edge: from corner c to the next */
static void share_on_edge(double corner[3][3], uint32_t c, const double at[3], double share[3])
{
    double edge[3], way[3];
    hatch_vec_sub(corner[(c + 1) % 3], corner[c], edge);
    hatch_vec_sub(at, corner[c], way);
    double square = hatch_vec_dot(edge, edge);
    share[(c + 2) % 3] = 0;
    share[(c + 1) % 3] = square > 0 ? hatch_vec_dot(way, edge) / square : 0;
    share[c] = 1 - share[(c + 1) % 3];
}

bool hatch_curve_find_share(const struct hatch_mesh *mesh, uint32_t face, const float position[3], float share[2])
{
    double corner[3][3], at[3], edge[3][3], way[3], shares[3], size = 0, longest = 0, sum = 0;
    uint32_t along = 0;
    hatch_vec_of(position, at);
    for (uint32_t c = 0; c < 3; c++)
        hatch_vec_of(&mesh->attributes[0].data[3 * (size_t)mesh->indices[3 * (size_t)face + c]], corner[c]);
    for (uint32_t c = 0; c < 3; c++) {
        hatch_vec_sub(corner[(c + 1) % 3], corner[c], edge[c]);
        double length = hatch_vec_length(edge[c]);
        along = length > longest ? c : along;
        longest = fmax(longest, length);
        for (int k = 0; k < 3; k++)
            size = fmax(size, fabs(corner[c][k]));
    }
    hatch_vec_sub(at, corner[0], way); /* edge[2] leads back to corner 0 */
    double aa = hatch_vec_dot(edge[0], edge[0]), bb = hatch_vec_dot(edge[2], edge[2]);
    double ab = -hatch_vec_dot(edge[0], edge[2]), a = hatch_vec_dot(way, edge[0]), b = -hatch_vec_dot(way, edge[2]);
    double det = aa * bb - ab * ab;
    if (det > FLAT * aa * bb) {
        shares[1] = (bb * a - ab * b) / det;
        shares[2] = (aa * b - ab * a) / det;
        shares[0] = 1 - shares[1] - shares[2];
    } else {
        share_on_edge(corner, along, at, shares);
    }
    for (int c = 0; c < 3; c++)
        sum += shares[c] = fmin(fmax(shares[c], 0), 1);
    for (int k = 0; k < 3; k++)
        for (int c = 0; c < 3; c++)
            at[k] -= shares[c] / sum * corner[c][k];
    share[0] = (float)(shares[1] / sum);
    share[1] = (float)(shares[2] / sum);
    return hatch_vec_length(at) <= (double)OUTSIDE * longest + ROUNDING * size;
}

static enum hatch_status check_point(const struct hatch_curves *curves, uint32_t i, const struct hatch_mesh *mesh,
                                     struct hatch_err *err)
{
    const struct hatch_curve_point *point = &curves->points[i];
    if (point->face >= mesh->face_count)
        return hatch_fail(err, HATCH_BAD_INPUT, "strokes: point %u: face %u does not exist, there are %u", i,
                          point->face, mesh->face_count);
    if (!(point->share[0] >= -OUTSIDE && point->share[1] >= -OUTSIDE &&
          point->share[0] + point->share[1] <= 1 + OUTSIDE))
        return hatch_fail(err, HATCH_BAD_INPUT, "strokes: point %u is outside of its face", i);
    if (!(point->threshold > 0 && point->threshold < HUGE_VALF))
        return hatch_fail(err, HATCH_BAD_INPUT, "strokes: point %u: threshold %g, want a number greater than 0", i,
                          (double)point->threshold);
    return HATCH_OK;
}

enum hatch_status hatch_curves_check(const struct hatch_curves *curves, const struct hatch_mesh *mesh,
                                     struct hatch_err *err)
{
    for (uint32_t i = 0; i < curves->set_count; i++) {
        const struct hatch_curve_set *set = &curves->sets[i], *before = i > 0 ? set - 1 : NULL;
        if (set->family >= HATCH_CURVE_FAMILIES_MAX || set->level >= HATCH_CURVE_LEVELS_MAX)
            return hatch_fail(err, HATCH_BAD_INPUT, "strokes: family %u, level %u: want at most %u and %u", set->family,
                              set->level, HATCH_CURVE_FAMILIES_MAX - 1, HATCH_CURVE_LEVELS_MAX - 1);
        if (before && (set->family < before->family || (set->family == before->family && set->level <= before->level)))
            return hatch_fail(err, HATCH_BAD_INPUT, "strokes: family %u, level %u is out of order", set->family,
                              set->level);
        if (!(set->gap > 0 && set->gap < HUGE_VALF && fabsf(set->angle_rad) < 100))
            return hatch_fail(err, HATCH_BAD_INPUT, "strokes: family %u, level %u: gap or angle out of range",
                              set->family, set->level);
    }
    for (uint32_t i = 0; i < curves->point_count; i++)
        HATCH_TRY(check_point(curves, i, mesh, err));
    return HATCH_OK;
}
