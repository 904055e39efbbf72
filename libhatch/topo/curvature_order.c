#include "math/vector.h"
#include "topo/curvature_work.h"

static enum hatch_status allocate(const struct hatch_surface *surface, struct hatch_arena *arena,
                                  struct hatch_curvature_terrain *terrain, struct hatch_err *err)
{
    size_t points = surface->point_count, entries = surface->ring_first[points];
    struct hatch_surface *out = &terrain->surface;
    *out = (struct hatch_surface){.point_count = surface->point_count,
                                  .component_count = surface->component_count,
                                  .components = surface->components};
    terrain->order = HATCH_NEW_UNSET(arena, uint32_t, points, err);
    terrain->normals = terrain->order ? HATCH_NEW_UNSET(arena, double, points * 3, err) : NULL;
    out->points = terrain->normals ? HATCH_NEW_UNSET(arena, double, points * 3, err) : NULL;
    out->point_component = out->points ? HATCH_NEW_UNSET(arena, uint32_t, points, err) : NULL;
    out->ring_first = out->point_component ? HATCH_NEW_UNSET(arena, uint32_t, points + 1, err) : NULL;
    out->ring_point = out->ring_first ? HATCH_NEW_UNSET(arena, uint32_t, entries, err) : NULL;
    out->ring_turned = out->ring_point ? HATCH_NEW_UNSET(arena, uint8_t, entries, err) : NULL;
    return out->ring_turned ? HATCH_OK : HATCH_LIMIT;
}

enum hatch_status hatch_curvature_order(const struct hatch_surface *surface,
                                        const struct hatch_frames *frames, struct hatch_arena *arena,
                                        struct hatch_curvature_terrain *terrain, struct hatch_err *err)
{
    HATCH_TRY(allocate(surface, arena, terrain, err));
    struct hatch_surface *out = &terrain->surface;
    uint32_t *number = HATCH_NEW_UNSET(arena, uint32_t, surface->point_count, err);
    if (!number)
        return HATCH_LIMIT;
    HATCH_TRY(hatch_surface_order(surface, arena, terrain->order, number, err));
    uint32_t entry = 0;
    for (uint32_t p = 0; p < surface->point_count; p++) {
        uint32_t old = terrain->order[p];
        hatch_vec_copy(&surface->points[(size_t)old * 3], &out->points[(size_t)p * 3]);
        hatch_vec_copy(&frames->normal[(size_t)old * 3], &terrain->normals[(size_t)p * 3]);
        out->point_component[p] = surface->point_component[old];
        out->ring_first[p] = entry;
        for (uint32_t i = surface->ring_first[old]; i < surface->ring_first[old + 1]; i++, entry++) {
            out->ring_point[entry] = number[surface->ring_point[i]];
            out->ring_turned[entry] = surface->ring_turned[i];
        }
    }
    out->ring_first[surface->point_count] = entry;
    return HATCH_OK;
}
