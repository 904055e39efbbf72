/* Ends of the ground, and the ways to them. */
#include <math.h>

#include "math/vector.h"
#include "mesh/fans.h"
#include "trace/ground.h"

static double edge_length(const struct hatch_surface *surface, uint32_t a, uint32_t b)
{
    return hatch_vec_distance(&surface->points[3 * (size_t)a], &surface->points[3 * (size_t)b]);
}

/* Finds the points on ends: their distance is 0, their length that of all ends that are connected with theirs. The
 * others have HUGE_VALF and 0. */
static enum hatch_status measure_ends(const struct hatch_trace_ground *ground, struct hatch_arena *arena,
                                      struct hatch_trace_end *ends, struct hatch_err *err)
{
    const struct hatch_surface *surface = ground->surface;
    uint32_t *set;
    double *length; /* per set */
    HATCH_TRY(HATCH_ALLOC_UNSET(arena, &set, surface->point_count, err));
    HATCH_TRY(HATCH_ALLOC(arena, &length, surface->point_count, err));
    hatch_sets_init(set, surface->point_count);
    for (uint32_t p = 0; p < surface->point_count; p++)
        ends[p] = (struct hatch_trace_end){HUGE_VALF, 0};
    for (int pass = 0; pass < 3; pass++) /* joins points, adds lengths, sets those of points */
        for (uint32_t side = 0; side < 3 * surface->face_count; side++) {
            if (ground->faces[side / 3].beyond[side % 3] != HATCH_NO_SIDE)
                continue;
            uint32_t source = 3 * ground->source[side / 3], from = source + side % 3;
            uint32_t a = surface->corners[from], b = surface->corners[source + (side + 1) % 3];
            if (pass == 0)
                hatch_sets_join(set, a, b);
            else if (pass == 1) /* hard edges have two sides */
                length[hatch_sets_find(set, a)] +=
                    edge_length(surface, a, b) * (surface->opposite[from] == HATCH_NO_SIDE ? 1 : 0.5);
            else
                ends[a] = ends[b] = (struct hatch_trace_end){0, (float)length[hatch_sets_find(set, a)]};
        }
    return HATCH_OK;
}

/* Points that wait for their turn: a ring in which each is at most once. */
struct queue {
    uint32_t *points, first, count;
    bool *waits; /* per point */
};

static void push(struct queue *queue, uint32_t point, uint32_t point_count)
{
    if (!queue->waits[point])
        queue->points[(uint32_t)(((uint64_t)queue->first + queue->count++) % point_count)] = point;
    queue->waits[point] = true;
}

/* Lowers the values of points to those of others and the way from there, along edges.
 *   values  in, out: per point */
static void spread(const struct hatch_surface *surface, struct queue *queue, float *values)
{
    uint32_t count = surface->point_count;
    for (uint32_t p = 0; p < count; p++)
        if (values[p] < HUGE_VALF)
            push(queue, p, count);
    while (queue->count > 0) {
        uint32_t p = queue->points[queue->first];
        queue->first = queue->first + 1 < count ? queue->first + 1 : 0;
        queue->count--;
        queue->waits[p] = false;
        for (uint32_t i = surface->ring_first[p]; i < surface->ring_first[p + 1]; i++) {
            uint32_t other = surface->ring_point[i];
            if (values[other] <= values[p])
                continue;
            float by = values[p] + (float)edge_length(surface, p, other);
            if (by < values[other]) {
                values[other] = by;
                push(queue, other, count);
            }
        }
    }
}

enum hatch_status hatch_trace_find_ends(const struct hatch_trace_ground *ground, struct hatch_arena *arena,
                                        struct hatch_trace_end **found, struct hatch_err *err)
{
    uint32_t count = ground->surface->point_count;
    struct hatch_trace_end *ends;
    struct queue queue = {0};
    float *values[2]; /* the distance, and that less the length */
    HATCH_TRY(HATCH_ALLOC_UNSET(arena, &ends, count, err));
    HATCH_TRY(HATCH_ALLOC_UNSET(arena, &queue.points, count, err));
    HATCH_TRY(HATCH_ALLOC(arena, &queue.waits, count, err));
    HATCH_TRY(measure_ends(ground, arena, ends, err));
    for (int k = 0; k < 2; k++) {
        HATCH_TRY(HATCH_ALLOC_UNSET(arena, &values[k], count, err));
        for (uint32_t p = 0; p < count; p++)
            values[k][p] = k == 0 ? ends[p].distance : ends[p].distance - ends[p].length;
        spread(ground->surface, &queue, values[k]);
    }
    for (uint32_t p = 0; p < count; p++)
        ends[p] = (struct hatch_trace_end){values[0][p], fmaxf(0, -values[1][p])};
    *found = ends;
    return HATCH_OK;
}

struct hatch_trace_end hatch_trace_end_near(const struct hatch_trace_ground *ground, uint32_t face)
{
    struct hatch_trace_end near = {HUGE_VALF, 0};
    for (uint32_t c = 0; c < 3; c++) {
        const struct hatch_trace_end *end = &ground->ends[ground->surface->corners[3 * ground->source[face] + c]];
        near.distance = fminf(near.distance, end->distance);
        near.length = fmaxf(near.length, end->length);
    }
    return near;
}
