#include <string.h>

#include "surface/surface.h"

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

enum hatch_status hatch_surface_order(const struct hatch_surface *surface, struct hatch_arena *arena, uint32_t *order,
                                      uint32_t *number, struct hatch_err *err)
{
    struct hatch_arena_mark mark = hatch_arena_mark(arena);
    struct numbering numbering = {.surface = surface, .order = order, .made = number};
    numbering.waiting = HATCH_NEW_UNSET(arena, uint32_t, surface->point_count, err);
    if (!numbering.waiting)
        return HATCH_LIMIT;
    memset(number, 0, surface->point_count * sizeof *number);
    number_points(&numbering);
    for (uint32_t p = 0; p < surface->point_count; p++)
        number[p]--;
    hatch_arena_rewind(arena, mark);
    return HATCH_OK;
}
