#include <math.h>

#include "math/vector.h"
#include "topo/curvature.h"

static void face_normal(const struct hatch_surface *surface, uint32_t face, double normal[3])
{
    const uint32_t *corner = &surface->corners[(size_t)face * 3];
    hatch_vec_triangle(&surface->points[(size_t)corner[0] * 3], &surface->points[(size_t)corner[1] * 3],
                       &surface->points[(size_t)corner[2] * 3], normal);
    hatch_vec_normalize(normal);
}

void hatch_curvature_doubt_creases(const struct hatch_surface *surface, double crease_rad,
                                   struct hatch_curvature *curvature)
{
    double flattest = cos(crease_rad), here[3], there[3];
    for (uint32_t side = 0; side < 3 * surface->face_count; side++) {
        uint32_t other = surface->opposite[side];
        if (other == HATCH_NO_SIDE || other < side)
            continue;
        uint32_t from = surface->corners[side], to = surface->corners[side % 3 == 2 ? side - 2 : side + 1];
        face_normal(surface, side / 3, here);
        face_normal(surface, other / 3, there);
        /* Across a contrary edge, which runs one way on both, one face shows its back. */
        double turned = surface->corners[other] == from ? -1 : 1;
        if (turned * hatch_vec_dot(here, there) < flattest)
            curvature->confidence[from] = curvature->confidence[to] = 0;
    }
}
