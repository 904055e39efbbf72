#include <math.h>
#include <string.h>

#include "math/vector.h"
#include "field/system.h"

/* What a vertex without confidence still says when no other says more. */
#define LEAST 1e-6

bool hatch_field_of_mesh(const struct hatch_surface *surface, const struct hatch_frames *frames,
                         const struct hatch_mesh *mesh, double *direction, double *confidence)
{
    const float *lines = hatch_mesh_find(mesh, "_HATCH_DIR", 4);
    if (!lines)
        return false;
    for (uint32_t p = 0; p < surface->point_count; p++) {
        double sum[2] = {0, 0}, corners = 0;
        for (uint32_t i = surface->ring_first[p]; i < surface->ring_first[p + 1]; i++) {
            uint32_t face = surface->ring_face[i];
            if (face == HATCH_NO_SIDE)
                continue;
            const uint32_t *corner = &surface->corners[(size_t)face * 3];
            uint32_t c = corner[0] == p ? 0 : corner[1] == p ? 1 : 2;
            const float *line = &lines[(size_t)surface->corner_vertex[(size_t)face * 3 + c] * 4];
            double wide[3], z[2], known = (double)line[3];
            hatch_vec_of(line, wide);
            hatch_field_square(frames, p, wide, z);
            known = (known > 0 ? fmin(known, 1) : 0) + LEAST;
            sum[0] += known * z[0];
            sum[1] += known * z[1];
            corners++;
        }
        double length = hypot(sum[0], sum[1]) / corners;
        confidence[p] = length > 2 * LEAST ? fmin(length - LEAST, 1) : 0;
        hatch_frames_direction(frames, p, atan2(sum[1], sum[0]) / 2, &direction[(size_t)p * 3]);
    }
    return true;
}
