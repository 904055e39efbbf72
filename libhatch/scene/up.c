#include "scene/up.h"

#include <math.h>

#include "math/vector.h"

#define SPREAD_MIN 0.15    /* smallest spread of a base */
#define RATIO_MIN 4        /* between the spreads of the bases along z and along y */
#define TOP_RATIO_MIN 2    /* between the spreads of the base and of the top along z */
#define BASE 0.01          /* height of a base, in heights of the mesh */
#define ONE_SIDE_SHARE 0.9 /* of the area of a height field, less that of its overhangs */

/* Returns the share of the bounding rectangle, seen along an axis, that the bounding rectangle of the lowest or of the
 * highest vertices covers. */
static double spread(const struct hatch_mesh *mesh, int axis, bool highest, const float low[3], const float high[3])
{
    const float *positions = mesh->attributes[0].data;
    double base = BASE * ((double)high[axis] - (double)low[axis]);
    double bottom = highest ? (double)high[axis] - base : (double)low[axis];
    double top = highest ? (double)high[axis] : (double)low[axis] + base;
    double share = 1;
    for (int k = 0; k < 3; k++) {
        float least = high[k], most = low[k];
        for (size_t i = 0; i < (size_t)mesh->face_count * 3 && k != axis; i++) {
            const float *p = &positions[(size_t)mesh->indices[i] * 3];
            if ((double)p[axis] < bottom || (double)p[axis] > top)
                continue;
            least = p[k] < least ? p[k] : least;
            most = p[k] > most ? p[k] : most;
        }
        if (k != axis)
            share *= ((double)most - (double)least) / ((double)high[k] - (double)low[k]);
    }
    return share;
}

/* Returns whether a mesh is a height field over the plane of x and z: seen along y, nearly all of it shows one side. */
static bool is_field_along_y(const struct hatch_mesh *mesh)
{
    double corners[3][3], normal[3], sum = 0, all = 0;
    for (uint32_t f = 0; f < mesh->face_count; f++) {
        hatch_mesh_corners(mesh, f, corners);
        hatch_vec_triangle(corners[0], corners[1], corners[2], normal);
        sum += normal[1];
        all += fabs(normal[1]);
    }
    return all > 0 && fabs(sum) >= ONE_SIDE_SHARE * all;
}

bool hatch_mesh_stands_along_z(const struct hatch_mesh *mesh)
{
    float low[3], high[3];
    if (!hatch_mesh_bounds(mesh, low, high) || !(low[0] < high[0] && low[1] < high[1] && low[2] < high[2]))
        return false;
    double along_z = spread(mesh, 2, false, low, high);
    return along_z >= SPREAD_MIN && along_z >= RATIO_MIN * spread(mesh, 1, false, low, high) &&
           along_z >= TOP_RATIO_MIN * spread(mesh, 2, true, low, high) && !is_field_along_y(mesh);
}
