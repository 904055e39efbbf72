#include "math/vector.h"
#include "curvature/work.h"

static enum hatch_status allocate(const struct hatch_surface *surface, struct hatch_arena *arena,
                                  struct hatch_curvature_graph *graph, struct hatch_err *err)
{
    size_t points = surface->point_count, entries = surface->ring_first[points];
    struct hatch_surface *out = &graph->surface;
    *graph = (struct hatch_curvature_graph){.surface = {.point_count = surface->point_count,
                                                        .component_count = surface->component_count,
                                                        .components = surface->components}};
    HATCH_TRY(HATCH_ALLOC_UNSET(arena, &graph->order, points, err));
    HATCH_TRY(HATCH_ALLOC_UNSET(arena, &graph->normals, points * 3, err));
    HATCH_TRY(HATCH_ALLOC_UNSET(arena, &out->points, points * 3, err));
    HATCH_TRY(HATCH_ALLOC_UNSET(arena, &out->point_component, points, err));
    HATCH_TRY(HATCH_ALLOC_UNSET(arena, &out->ring_first, points + 1, err));
    HATCH_TRY(HATCH_ALLOC_UNSET(arena, &out->ring_point, entries, err));
    return HATCH_ALLOC_UNSET(arena, &out->ring_turned, entries, err);
}

/* A normal that differs more than this from the mean around it is taken for noise, */
#define NORMAL_COSINE_MIN 0.7
/* where the faces around agree on a side: their vector areas sum to at least this share of their areas. At the edge of
 * a thin body they do not agree, and the normal is right. */
#define AGREEMENT_MIN 0.5

/* Sums the vector areas of the faces around a point; the sum does not depend on the point's own position.
 *   sum  out: vector area, and in [3] the area */
static void sum_areas(const struct hatch_surface *surface, uint32_t p, double sum[4])
{
    for (uint32_t i = surface->ring_first[p]; i < surface->ring_first[p + 1]; i++) {
        uint32_t face = surface->ring_face[i];
        double area[3];
        if (face == HATCH_NO_SIDE)
            continue;
        hatch_surface_face_normal(surface, face, area);
        hatch_vec_add_scaled(sum, surface->ring_flipped[i] ? -1 : 1, area, sum);
        sum[3] += hatch_vec_length(area);
    }
}

/* Repairs a normal of the frames. Those weight a face by its angle, so that a sliver flipped by noise counts in full;
 * supports of other points would not accept a point with such a normal.
 *   areas  4 per point, of sum_areas */
static void repair_normal(const struct hatch_surface *surface, const struct hatch_frames *frames, const double *areas,
                          uint32_t p, double normal[3])
{
    double sum[3], area = areas[(size_t)p * 4 + 3];
    hatch_vec_copy(&frames->normal[(size_t)p * 3], normal);
    hatch_vec_copy(&areas[(size_t)p * 4], sum);
    for (uint32_t i = surface->ring_first[p]; i < surface->ring_first[p + 1]; i++) {
        const double *around = &areas[(size_t)surface->ring_point[i] * 4];
        hatch_vec_add_scaled(sum, surface->ring_turned[i] ? -1 : 1, around, sum);
        area += around[3];
    }
    double length = hatch_vec_normalize(sum);
    if (length > 0 && length >= AGREEMENT_MIN * area && hatch_vec_dot(sum, normal) < NORMAL_COSINE_MIN)
        hatch_vec_copy(sum, normal);
}

enum hatch_status hatch_curvature_graph_make(const struct hatch_surface *surface, const struct hatch_frames *frames,
                                             struct hatch_arena *arena, struct hatch_curvature_graph *graph,
                                             struct hatch_err *err)
{
    HATCH_TRY(allocate(surface, arena, graph, err));
    struct hatch_surface *out = &graph->surface;
    uint32_t *number;
    double *areas;
    HATCH_TRY(HATCH_ALLOC_UNSET(arena, &number, surface->point_count, err));
    HATCH_TRY(HATCH_ALLOC(arena, &areas, (size_t)surface->point_count * 4, err));
    for (uint32_t p = 0; p < surface->point_count; p++)
        sum_areas(surface, p, &areas[(size_t)p * 4]);
    HATCH_TRY(hatch_surface_order_points(surface, arena, graph->order, number, err));
    uint32_t entry = 0;
    for (uint32_t p = 0; p < surface->point_count; p++) {
        uint32_t original = graph->order[p];
        hatch_vec_copy(&surface->points[(size_t)original * 3], &out->points[(size_t)p * 3]);
        repair_normal(surface, frames, areas, original, &graph->normals[(size_t)p * 3]);
        out->point_component[p] = surface->point_component[original];
        out->ring_first[p] = entry;
        for (uint32_t i = surface->ring_first[original]; i < surface->ring_first[original + 1]; i++, entry++) {
            out->ring_point[entry] = number[surface->ring_point[i]];
            out->ring_turned[entry] = surface->ring_turned[i];
        }
    }
    out->ring_first[surface->point_count] = entry;
    return HATCH_OK;
}
