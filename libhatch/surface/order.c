#include <string.h>

#include "surface/surface.h"

#define BLOCK_POINTS 256u /* largest number of points of a block */
#define QUEUED UINT32_MAX

struct numbering {
    const struct hatch_surface *surface;
    uint32_t count, *order; /* the points numbered so far */
    uint32_t *state;        /* per point: the new number plus one, QUEUED, or 0: unvisited */
    uint32_t *queue;        /* points at which blocks may start */
    uint32_t queue_count;
};

static void number_point(struct numbering *n, uint32_t point)
{
    n->order[n->count++] = point;
    n->state[point] = n->count;
}

/* Numbers points in breadth-first order from start until the block is full; unnumbered neighbours are queued as starts
 * of further blocks. */
static void number_block(struct numbering *n, uint32_t start)
{
    const uint32_t *ring_first = n->surface->ring_first;
    uint32_t first = n->count;
    number_point(n, start);
    for (uint32_t next = first; next < n->count; next++)
        for (uint32_t p = n->order[next], i = ring_first[p]; i < ring_first[p + 1]; i++) {
            uint32_t q = n->surface->ring_point[i];
            if (n->state[q] != 0 && n->state[q] != QUEUED)
                continue;
            if (n->count - first < BLOCK_POINTS) {
                number_point(n, q);
            } else if (n->state[q] == 0) {
                n->state[q] = QUEUED;
                n->queue[n->queue_count++] = q;
            }
        }
}

/* Numbers block by block: in a single breadth-first traversal (Cuthill & McKee, "Reducing the bandwidth of sparse
 * symmetric matrices", 1969) the numbers of neighbours would differ by the size of a whole front. */
static void number_points(struct numbering *n)
{
    for (uint32_t start = 0; start < n->surface->point_count; start++) {
        if (n->state[start] != 0)
            continue;
        n->queue[0] = start;
        n->queue_count = 1;
        for (uint32_t next = 0; next < n->queue_count; next++) {
            uint32_t p = n->queue[next];
            if (n->state[p] == 0 || n->state[p] == QUEUED)
                number_block(n, p);
        }
    }
}

enum hatch_status hatch_surface_order_points(const struct hatch_surface *surface, struct hatch_arena *arena,
                                             uint32_t *order, uint32_t *number, struct hatch_err *err)
{
    struct hatch_arena_mark mark = hatch_arena_mark(arena);
    struct numbering numbering = {.surface = surface, .order = order, .state = number};
    HATCH_TRY(HATCH_ALLOC_UNSET(arena, &numbering.queue, surface->point_count, err));
    memset(number, 0, surface->point_count * sizeof *number);
    number_points(&numbering);
    for (uint32_t p = 0; p < surface->point_count; p++)
        number[p]--;
    hatch_arena_rewind(arena, mark);
    return HATCH_OK;
}
