#include "math/vector.h"
#include "topo/curvature_work.h"

#define PATCH 256u
#define WAITING UINT32_MAX

struct numbering {
    const struct hatch_surface *surface;
    uint32_t count, *order; /* points numbered, by their new numbers */
    uint32_t *made;         /* per point: the new number plus one, WAITING, or 0: not met */
    uint32_t *waiting;      /* points that patches may begin at */
    uint32_t wait_count;
};

static void number_point(struct numbering *n, uint32_t point)
{
    n->order[n->count++] = point;
    n->made[point] = n->count;
}

/* A walk from neighbour to neighbour numbers what it meets until the patch is full, and leaves the rest to others. */
static void number_patch(struct numbering *n, uint32_t seed)
{
    const uint32_t *ring_first = n->surface->ring_first;
    uint32_t first = n->count;
    number_point(n, seed);
    for (uint32_t next = first; next < n->count; next++)
        for (uint32_t p = n->order[next], i = ring_first[p]; i < ring_first[p + 1]; i++) {
            uint32_t q = n->surface->ring_point[i];
            if (n->made[q] != 0 && n->made[q] != WAITING)
                continue;
            if (n->count - first < PATCH) {
                number_point(n, q);
            } else if (n->made[q] == 0) {
                n->made[q] = WAITING;
                n->waiting[n->wait_count++] = q;
            }
        }
}

/* Patch by patch: one walk over all (Cuthill & McKee, "Reducing the bandwidth of sparse symmetric matrices", 1969)
 * puts a whole front between neighbours. */
static void number_points(struct numbering *n)
{
    for (uint32_t start = 0; start < n->surface->point_count; start++) {
        if (n->made[start] != 0)
            continue;
        n->waiting[0] = start;
        n->wait_count = 1;
        for (uint32_t next = 0; next < n->wait_count; next++) {
            uint32_t seed = n->waiting[next];
            if (n->made[seed] == 0 || n->made[seed] == WAITING)
                number_patch(n, seed);
        }
    }
}

static enum hatch_status allocate(const struct hatch_surface *surface, struct hatch_arena *arena,
                                  struct hatch_curvature_terrain *terrain, struct hatch_err *err)
{
    size_t points = surface->point_count, entries = surface->ring_first[points];
    struct hatch_surface *out = &terrain->surface;
    *out = (struct hatch_surface){.point_count = surface->point_count,
                                  .component_count = surface->component_count,
                                  .components = surface->components};
    terrain->order = HATCH_NEW(arena, uint32_t, points, err);
    terrain->normals = terrain->order ? HATCH_NEW(arena, double, points * 3, err) : NULL;
    out->points = terrain->normals ? HATCH_NEW(arena, double, points * 3, err) : NULL;
    out->point_component = out->points ? HATCH_NEW(arena, uint32_t, points, err) : NULL;
    out->ring_first = out->point_component ? HATCH_NEW(arena, uint32_t, points + 1, err) : NULL;
    out->ring_point = out->ring_first ? HATCH_NEW(arena, uint32_t, entries, err) : NULL;
    out->ring_turned = out->ring_point ? HATCH_NEW(arena, uint8_t, entries, err) : NULL;
    return out->ring_turned ? HATCH_OK : HATCH_LIMIT;
}

enum hatch_status hatch_curvature_order(const struct hatch_surface *surface,
                                        const struct hatch_frames *frames, struct hatch_arena *arena,
                                        struct hatch_curvature_terrain *terrain, struct hatch_err *err)
{
    HATCH_TRY(allocate(surface, arena, terrain, err));
    struct hatch_surface *out = &terrain->surface;
    struct numbering numbering = {.surface = surface, .order = terrain->order};
    numbering.made = HATCH_NEW(arena, uint32_t, surface->point_count, err);
    numbering.waiting = numbering.made ? HATCH_NEW(arena, uint32_t, surface->point_count, err) : NULL;
    if (!numbering.waiting)
        return HATCH_LIMIT;
    number_points(&numbering);
    uint32_t entry = 0;
    for (uint32_t p = 0; p < surface->point_count; p++) {
        uint32_t old = terrain->order[p];
        hatch_vec_copy(&surface->points[(size_t)old * 3], &out->points[(size_t)p * 3]);
        hatch_vec_copy(&frames->normal[(size_t)old * 3], &terrain->normals[(size_t)p * 3]);
        out->point_component[p] = surface->point_component[old];
        out->ring_first[p] = entry;
        for (uint32_t i = surface->ring_first[old]; i < surface->ring_first[old + 1]; i++, entry++) {
            out->ring_point[entry] = numbering.made[surface->ring_point[i]] - 1;
            out->ring_turned[entry] = surface->ring_turned[i];
        }
    }
    out->ring_first[surface->point_count] = entry;
    return HATCH_OK;
}
