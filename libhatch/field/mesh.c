#include <math.h>

#include "math/vector.h"
#include "field/system.h"

#define WEIGHT_MIN 1e-6 /* of vertices of confidence 0: they count where all around have it */

bool hatch_field_of_mesh(const struct hatch_surface *surface, const struct hatch_frames *frames,
                         const struct hatch_mesh *mesh, double *direction, double *confidence)
{
    const float *values = hatch_mesh_find(mesh, "_HATCH_DIR", 4);
    if (!values)
        return false;
    for (uint32_t p = 0; p < surface->point_count; p++) {
        double sum[2] = {0, 0}, corners = 0;
        for (uint32_t i = surface->ring_first[p]; i < surface->ring_first[p + 1]; i++) {
            uint32_t face = surface->ring_face[i];
            if (face == HATCH_NO_SIDE)
                continue;
            const uint32_t *corner = &surface->corners[(size_t)face * 3];
            uint32_t c = corner[0] == p ? 0 : corner[1] == p ? 1 : 2;
            const float *value = &values[(size_t)surface->corner_vertex[(size_t)face * 3 + c] * 4];
            double corner_direction[3], z[2], weight = (double)value[3];
            hatch_vec_of(value, corner_direction);
            hatch_field_encode(frames, p, corner_direction, z);
            weight = (weight > 0 ? fmin(weight, 1) : 0) + WEIGHT_MIN;
            sum[0] += weight * z[0];
            sum[1] += weight * z[1];
            corners++;
        }
        double length = hypot(sum[0], sum[1]) / corners;
        confidence[p] = length > 2 * WEIGHT_MIN ? fmin(length - WEIGHT_MIN, 1) : 0;
        hatch_frames_direction(frames, p, atan2(sum[1], sum[0]) / 2, &direction[(size_t)p * 3]);
    }
    return true;
}
