#include "surface/nearest.h"

#include <assert.h>

#include "math/vector.h"

enum hatch_status hatch_surface_points_make(const struct hatch_surface *surface, struct hatch_arena *arena,
                                            struct hatch_surface_points *points, struct hatch_err *err)
{
    double *positions;
    HATCH_TRY(HATCH_ALLOC_UNSET(arena, &positions, 3 * (size_t)surface->point_count, err));
    for (uint32_t p = 0; p < surface->point_count; p++)
        hatch_surface_position(surface, p, &positions[3 * (size_t)p]);
    points->surface = surface;
    return hatch_point_tree_make(positions, surface->point_count, arena, &points->tree, err);
}

struct search {
    const struct hatch_surface *surface;
    const double *position;
};

/* In the units of the component, which are more exact far from the origin than the positions. */
static double distance(const void *context, uint32_t point)
{
    const struct search *search = context;
    const struct hatch_component *component = &search->surface->components[search->surface->point_component[point]];
    double local[3];
    for (int k = 0; k < 3; k++)
        local[k] = (search->position[k] - component->center[k]) / component->scale;
    return hatch_vec_distance(local, &search->surface->points[3 * (size_t)point]) * component->scale;
}

uint32_t hatch_surface_nearest(const struct hatch_surface_points *points, const double position[3])
{
    const struct search search = {points->surface, position};
    uint32_t nearest = hatch_point_tree_nearest(&points->tree, position, distance, &search);
    return nearest == HATCH_POINT_NONE ? 0 : nearest;
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

enum hatch_status hatch_surface_group_points(const struct hatch_surface *surface, const uint32_t *group_of,
                                             uint32_t group_count, struct hatch_arena *arena,
                                             struct hatch_surface_groups *groups, struct hatch_err *err)
{
    size_t corners = 3 * (size_t)surface->face_count;
    struct hatch_surface_groups made;
    HATCH_TRY(HATCH_ALLOC(arena, &made.first, (size_t)group_count + 2, err));
    HATCH_TRY(HATCH_ALLOC_UNSET(arena, &made.points, corners, err));
    HATCH_TRY(HATCH_ALLOC(arena, &made.group, surface->point_count, err));
    for (size_t i = 0; i < corners; i++) {
        uint32_t vertex = surface->corner_vertex[i], g = group_of ? group_of[vertex] : vertex;
        assert(g < group_count);
        made.group[surface->corners[i]] = g;
        made.first[g + 2]++;
    }
    for (uint32_t g = 0; g < group_count; g++)
        made.first[g + 2] += made.first[g + 1];
    for (size_t i = 0; i < corners; i++) {
        uint32_t vertex = surface->corner_vertex[i], g = group_of ? group_of[vertex] : vertex;
        made.points[made.first[g + 1]++] = surface->corners[i];
    }
    *groups = made;
    return HATCH_OK;
}
