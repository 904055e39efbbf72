#include <assert.h>
#include <math.h>

#include "math/vector.h"
#include "curvature/curvature.h"

/* Whether two faces, one of them turned over where turned is -1, meet at more than an acute angle of this cosine. */
static bool is_crease(const struct hatch_surface *surface, uint32_t a, uint32_t b, double turned, double cosine)
{
    double here[3], there[3];
    hatch_surface_normal(surface, a, here);
    hatch_surface_normal(surface, b, there);
    double dot = turned * hatch_vec_dot(here, there);
    return !(dot > 0) || dot * dot < cosine * cosine * hatch_vec_dot(here, here) * hatch_vec_dot(there, there);
}

void hatch_curvature_doubt_creases(const struct hatch_surface *surface, double crease_rad,
                                   struct hatch_curvature *curvature)
{
    double flattest = cos(crease_rad);
    assert(flattest > 0);
    for (uint32_t side = 0; side < 3 * surface->face_count; side++) {
        uint32_t other = surface->opposite[side];
        if (other == HATCH_NO_SIDE || other < side)
            continue;
        uint32_t from = surface->corners[side], to = surface->corners[side % 3 == 2 ? side - 2 : side + 1];
        /* Across a contrary edge, which runs one way on both, one face shows its back. */
        double turned = surface->corners[other] == from ? -1 : 1;
        if (is_crease(surface, side / 3, other / 3, turned, flattest))
            curvature->confidence[from] = curvature->confidence[to] = 0;
    }
}
