#include "surface/nearest.h"

#include <assert.h>
#include <math.h>

#include "math/vector.h"

uint32_t hatch_surface_nearest(const struct hatch_surface *surface, const double position[3])
{
    uint32_t nearest = 0;
    double least = INFINITY;
    for (uint32_t c = 0; c < surface->component_count; c++) {
        const struct hatch_component *component = &surface->components[c];
        double local[3];
        for (int k = 0; k < 3; k++)
            local[k] = (position[k] - component->center[k]) / component->scale;
        for (uint32_t i = 0; i < component->point_count; i++) {
            uint32_t p = component->first_point + i;
            double length = hatch_vec_distance(local, &surface->points[3 * (size_t)p]) * component->scale;
            if (!(length < least))
                continue;
            least = length;
            nearest = p;
        }
    }
    return nearest;
}

void hatch_surface_vertex_points(const struct hatch_surface *surface, uint32_t vertex_count, uint32_t *points)
{
    for (uint32_t v = 0; v < vertex_count; v++)
        points[v] = HATCH_NO_SIDE;
    for (size_t i = 0; i < (size_t)surface->face_count * 3; i++) {
        uint32_t v = surface->corner_vertex[i];
        assert(v < vertex_count);
        if (surface->corners[i] < points[v]) /* HATCH_NO_SIDE is the largest number */
            points[v] = surface->corners[i];
    }
}
