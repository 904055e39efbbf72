#include <assert.h>
#include <math.h>

#include "math/vector.h"
#include "curvature/curvature.h"

/* Whether the normals of two faces differ by more than an acute angle.
 *   sign    -1 where the faces are oriented inconsistently, else 1
 *   cosine  of the angle */
static bool is_crease(const struct hatch_surface *surface, uint32_t a, uint32_t b, double sign, double cosine)
{
    double here[3], there[3];
    hatch_surface_face_normal(surface, a, here);
    hatch_surface_face_normal(surface, b, there);
    double dot = sign * hatch_vec_dot(here, there);
    return !(dot > 0) || dot * dot < cosine * cosine * hatch_vec_dot(here, here) * hatch_vec_dot(there, there);
}

void hatch_curvature_set_planes(const struct hatch_surface *surface, struct hatch_curvature *curvature)
{
    for (uint32_t i = 0; surface->plane_count > 0 && i < 3 * surface->face_count; i++) {
        uint32_t plane = surface->face_plane[i / 3];
        size_t p = surface->corners[i];
        if (plane == HATCH_NO_SIDE)
            continue;
        double normal[3], *out = &curvature->normal[3 * p];
        hatch_surface_face_normal(surface, i / 3, normal);
        hatch_vec_normalize(normal);
        double side = hatch_vec_dot(normal, out) < 0 ? -1 : 1;
        for (int k = 0; k < 3; k++)
            out[k] = side * normal[k];
        hatch_vec_copy(&surface->plane_direction[3 * (size_t)plane], &curvature->direction[3 * p]);
        curvature->value[2 * p] = 1;
        curvature->value[2 * p + 1] = 0;
        curvature->confidence[p] = 1;
        curvature->standard_error_rad[p] = 0;
    }
}

void hatch_curvature_clear_crease_confidence(const struct hatch_surface *surface, double crease_rad,
                                             struct hatch_curvature *curvature)
{
    double cosine = cos(crease_rad);
    assert(cosine > 0);
    for (uint32_t side = 0; side < 3 * surface->face_count; side++) {
        uint32_t other = surface->opposite[side];
        if (other == HATCH_NO_SIDE || other < side)
            continue;
        uint32_t from = surface->corners[side], to = surface->corners[side % 3 == 2 ? side - 2 : side + 1];
        double sign = surface->corners[other] == from ? -1 : 1; /* -1 across a contrary edge */
        if (is_crease(surface, side / 3, other / 3, sign, cosine))
            curvature->confidence[from] = curvature->confidence[to] = 0;
    }
}
