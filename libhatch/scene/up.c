#include "scene/up.h"

#define SPREAD_MIN 0.15 /* smallest spread of a base */
#define RATIO_MIN 4     /* between the spreads along z and along y */
#define BASE 0.01       /* height of a base, in heights of the mesh */

/* Returns the share of the bounding rectangle, seen along an axis, that the bounding rectangle of the lowest vertices
 * covers. */
static double spread(const struct hatch_mesh *mesh, int axis, const float low[3], const float high[3])
{
    const float *positions = mesh->attributes[0].data;
    double top = (double)low[axis] + BASE * ((double)high[axis] - (double)low[axis]);
    double share = 1;
    for (int k = 0; k < 3; k++) {
        float least = high[k], most = low[k];
        for (size_t i = 0; i < (size_t)mesh->face_count * 3 && k != axis; i++) {
            const float *p = &positions[(size_t)mesh->indices[i] * 3];
            if ((double)p[axis] > top)
                continue;
            least = p[k] < least ? p[k] : least;
            most = p[k] > most ? p[k] : most;
        }
        if (k != axis)
            share *= ((double)most - (double)least) / ((double)high[k] - (double)low[k]);
    }
    return share;
}

bool hatch_mesh_stands_along_z(const struct hatch_mesh *mesh)
{
    float low[3], high[3];
    if (!hatch_mesh_bounds(mesh, low, high) || !(low[0] < high[0] && low[1] < high[1] && low[2] < high[2]))
        return false;
    double along_z = spread(mesh, 2, low, high);
    return along_z >= SPREAD_MIN && along_z >= RATIO_MIN * spread(mesh, 1, low, high);
}
