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

/* Computes the distance from a position to the place with the given shares of the corners. */
static double distance_to(double corner[3][3], const double share[3], const double at[3])
{
    double place[3] = {0, 0, 0};
    for (int c = 0; c < 3; c++)
        for (int k = 0; k < 3; k++)
            place[k] += share[c] * corner[c][k];
    return hatch_vec_distance(place, at);
}

/* Finds the place on the edges of a face that is nearest to a position. */
static void find_on_edges(double corner[3][3], const double at[3], double share[3])
{
    double nearest = HUGE_VAL;
    for (uint32_t c = 0; c < 3; c++) {
        uint32_t next = (c + 1) % 3;
        double edge[3], way[3], found[3] = {0, 0, 0};
        hatch_vec_sub(corner[next], corner[c], edge);
        hatch_vec_sub(at, corner[c], way);
        double square = hatch_vec_dot(edge, edge);
        found[next] = square > 0 ? fmin(fmax(hatch_vec_dot(way, edge) / square, 0), 1) : 0;
        found[c] = 1 - found[next];
        double distance = distance_to(corner, found, at);
        if (distance < nearest) {
            nearest = distance;
            hatch_vec_copy(found, share);
        }
    }
}

bool hatch_curve_find_share(const struct hatch_mesh *mesh, uint32_t face, const float position[3], float share[2])
{
    double corner[3][3], at[3], edge[2][3], way[3], shares[3] = {-1, -1, -1}, size = 0, longest = 0;
    hatch_vec_of(position, at);
    for (uint32_t c = 0; c < 3; c++)
        hatch_vec_of(&mesh->attributes[0].data[3 * (size_t)mesh->indices[3 * (size_t)face + c]], corner[c]);
    for (uint32_t c = 0; c < 3; c++) {
        longest = fmax(longest, hatch_vec_distance(corner[c], corner[(c + 1) % 3]));
        for (int k = 0; k < 3; k++)
            size = fmax(size, fabs(corner[c][k]));
    }
    for (int e = 0; e < 2; e++)
        hatch_vec_sub(corner[e + 1], corner[0], edge[e]);
    hatch_vec_sub(at, corner[0], way);
    double aa = hatch_vec_dot(edge[0], edge[0]), bb = hatch_vec_dot(edge[1], edge[1]);
    double ab = hatch_vec_dot(edge[0], edge[1]), a = hatch_vec_dot(way, edge[0]), b = hatch_vec_dot(way, edge[1]);
    double det = aa * bb - ab * ab;
    if (det > FLAT * aa * bb) {
        shares[1] = (bb * a - ab * b) / det;
        shares[2] = (aa * b - ab * a) / det;
        shares[0] = 1 - shares[1] - shares[2];
    }
    if (fmin(fmin(shares[0], shares[1]), shares[2]) < 0)
        find_on_edges(corner, at, shares);
    share[0] = (float)shares[1];
    share[1] = (float)shares[2];
    return distance_to(corner, shares, at) <= (double)OUTSIDE * longest + ROUNDING * size;
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
