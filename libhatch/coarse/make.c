#include <math.h>
#include <string.h>

#include "coarse/work.h"

/* Queues a point with its cheapest neighbour that costs more than `above`, or as much and has a higher number than
 * `after`; takes it out of the queue where there is none. */
static void queue_point(struct hatch_coarse_work *work, const struct hatch_coarse_ring *ring, double above,
                        uint32_t after)
{
    double best = INFINITY;
    uint32_t target = HATCH_COARSE_NONE;
    bool fixed = ring->border_count != 0 && ring->border_count != 2;
    for (uint32_t i = 0; i < ring->spoke_count && !fixed; i++) {
        const struct hatch_coarse_spoke *spoke = &ring->spokes[i];
        if (ring->border_count > 0 && !spoke->border)
            continue;
        double cost = hatch_coarse_cost(work, ring->point, spoke->point);
        if (!(cost > above || (cost == above && spoke->point > after)))
            continue;
        if (cost < best || (cost == best && spoke->point < target)) {
            best = cost;
            target = spoke->point;
        }
    }
    work->target[ring->point] = target;
    if (target == HATCH_COARSE_NONE)
        hatch_coarse_queue_drop(&work->queue, ring->point);
    else
        hatch_coarse_queue_set(&work->queue, ring->point, best);
}

/* Queues a point with its cheapest neighbour. One without a ring may stay in the queue: try_point passes it over. */
static void queue_anew(struct hatch_coarse_work *work, uint32_t point)
{
    struct hatch_coarse_ring ring;
    if (hatch_coarse_ring_find(work, point, &ring))
        queue_point(work, &ring, -1, 0);
}

/* Tries the best collapse of a point. */
static void try_point(struct hatch_coarse_work *work, uint32_t point)
{
    struct hatch_coarse_ring ring;
    struct hatch_coarse_collapse collapse;
    uint32_t onto = work->target[point], s = 0;
    if (!hatch_coarse_ring_find(work, point, &ring))
        return;
    while (ring.spokes[s].point != onto)
        s++;
    if (!hatch_coarse_collapse_find(work, &ring, &ring.spokes[s], &collapse) || !hatch_coarse_judge(work, &collapse)) {
        queue_point(work, &ring, work->queue.key[point], onto);
        return;
    }
    hatch_coarse_apply(work, &collapse);
    queue_anew(work, onto);
    for (uint32_t i = 0; i < ring.spoke_count; i++)
        if (ring.spokes[i].point != onto)
            queue_anew(work, ring.spokes[i].point);
}

/* Makes the mesh of what is left of a part. */
static enum hatch_status store(const struct hatch_coarse_work *work, uint32_t part, struct hatch_arena *arena,
                               struct hatch_arena *scratch, struct hatch_mesh *out, struct hatch_err *err)
{
    const struct hatch_mesh *mesh = work->parts[part].mesh;
    uint32_t *number, *origin, count = 0, faces = 0;
    HATCH_TRY(HATCH_ALLOC(scratch, &number, mesh->vertex_count, err));
    HATCH_TRY(HATCH_ALLOC(scratch, &origin, mesh->vertex_count, err));
    for (uint32_t f = work->first_face[part]; f < work->first_face[part + 1]; f++) {
        bool live = work->corner[3 * (size_t)f] != HATCH_COARSE_NONE;
        faces += live;
        for (uint32_t c = 0; c < 3 && live; c++)
            number[work->corner[3 * (size_t)f + c] - work->first_wedge[part]] = 1;
    }
    for (uint32_t v = 0; v < mesh->vertex_count; v++)
        if (number[v]) {
            number[v] = count;
            origin[count++] = v;
        }
    HATCH_TRY(hatch_mesh_gather(mesh, origin, count, faces, arena, out, err));
    uint32_t *index = out->indices;
    for (uint32_t f = work->first_face[part]; f < work->first_face[part + 1]; f++)
        for (uint32_t c = 0; c < 3 && work->corner[3 * (size_t)f] != HATCH_COARSE_NONE; c++)
            *index++ = number[work->corner[3 * (size_t)f + c] - work->first_wedge[part]];
    return HATCH_OK;
}

static enum hatch_status make(const struct hatch_coarse_part *parts, uint32_t part_count, bool loose,
                              struct hatch_arena *arena, struct hatch_arena *scratch, struct hatch_mesh *out,
                              struct hatch_err *err)
{
    struct hatch_coarse_work work;
    struct hatch_mesh *made;
    uint32_t point;
    HATCH_TRY(HATCH_ALLOC(scratch, &made, part_count, err));
    HATCH_TRY(hatch_coarse_load(parts, part_count, scratch, scratch, &work, err));
    work.loose = loose;
    for (uint32_t f = 0; f < work.face_count && loose; f++)
        work.first_sample[f] = HATCH_COARSE_NONE;
    hatch_coarse_quadrics_make(&work);
    for (uint32_t p = 0; p < work.point_count; p++)
        queue_anew(&work, p);
    while (hatch_coarse_queue_pop(&work.queue, &point))
        try_point(&work, point);
    for (uint32_t part = 0; part < part_count; part++)
        HATCH_TRY(store(&work, part, arena, scratch, &made[part], err));
    memcpy(out, made, part_count * sizeof *made);
    return HATCH_OK;
}

static enum hatch_status make_and_rewind(const struct hatch_coarse_part *parts, uint32_t part_count, bool loose,
                                         struct hatch_arena *arena, struct hatch_arena *scratch, struct hatch_mesh *out,
                                         struct hatch_err *err)
{
    struct hatch_arena_mark mark = hatch_arena_mark(scratch);
    enum hatch_status status = make(parts, part_count, loose, arena, scratch, out, err);
    hatch_arena_rewind(scratch, mark);
    return status;
}

enum hatch_status hatch_coarse_make(const struct hatch_coarse_part *parts, uint32_t part_count,
                                    struct hatch_arena *arena, struct hatch_arena *scratch, struct hatch_mesh *out,
                                    struct hatch_err *err)
{
    return make_and_rewind(parts, part_count, false, arena, scratch, out, err);
}

enum hatch_status hatch_coarse_make_loosely(const struct hatch_coarse_part *parts, uint32_t part_count,
                                            struct hatch_arena *arena, struct hatch_arena *scratch,
                                            struct hatch_mesh *out, struct hatch_err *err)
{
    return make_and_rewind(parts, part_count, true, arena, scratch, out, err);
}
