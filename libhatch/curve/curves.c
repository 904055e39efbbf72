#include "curve/curves.h"

#include <math.h>

#define OUTSIDE 1e-3f /* share by which rounding may place a point outside of its face */

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
