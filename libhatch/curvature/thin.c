#include "math/vector.h"
#include "curvature/work.h"

#define TOGETHER 2u     /* nodes that become one, at most */
#define LEAN_COSINE 0.7 /* between their normals: what stood for both sides of an edge would lie beside it */

struct thinning {
    const struct hatch_curvature_terrain *finest, *fine;
    struct hatch_curvature_terrain *coarse;
    uint32_t count;         /* of coarse nodes */
    uint32_t *number;       /* per fine node: its coarse one plus one; 0: free */
    int8_t *side;           /* per fine node: -1 where its outside is not the coarse one's */
    uint32_t *first, *list; /* the fine nodes by coarse ones */
    uint32_t *slot;         /* per coarse node: the entry for it in the ring in work, plus one */
};

/* Takes the nearest neighbour that is free; false when there is none. */
static bool take_nearest(struct thinning *t, uint32_t p)
{
    const struct hatch_surface *fine = &t->fine->surface;
    const double *normals = t->fine->normals;
    double least = INFINITY;
    uint32_t best = 0;
    for (uint32_t i = fine->ring_first[p]; i < fine->ring_first[p + 1]; i++) {
        uint32_t q = fine->ring_point[i];
        if (t->number[q])
            continue;
        double lean = hatch_vec_dot(&normals[3 * (size_t)p], &normals[3 * (size_t)q]);
        double length = hatch_vec_distance(&fine->points[3 * (size_t)p], &fine->points[3 * (size_t)q]);
        if ((fine->ring_turned[i] ? -lean : lean) < LEAN_COSINE || !(length < least))
            continue;
        least = length;
        best = i;
    }
    if (!(least < INFINITY))
        return false;
    t->number[fine->ring_point[best]] = t->count;
    t->side[fine->ring_point[best]] = fine->ring_turned[best] ? -1 : 1;
    return true;
}

static void join_nodes(struct thinning *t)
{
    for (uint32_t p = 0; p < t->fine->surface.point_count; p++) {
        if (t->number[p])
            continue;
        t->number[p] = ++t->count;
        t->side[p] = 1;
        for (uint32_t more = 1; more < TOGETHER && take_nearest(t, p); more++)
            ;
    }
}

static enum hatch_status group_nodes(struct thinning *t, struct hatch_arena *arena, struct hatch_err *err)
{
    uint32_t nodes = t->fine->surface.point_count;
    t->first = HATCH_NEW(arena, uint32_t, (size_t)t->count + 2, err);
    t->list = t->first ? HATCH_NEW_UNSET(arena, uint32_t, nodes, err) : NULL;
    t->slot = t->list ? HATCH_NEW(arena, uint32_t, t->count, err) : NULL;
    if (!t->slot)
        return HATCH_LIMIT;
    for (uint32_t p = 0; p < nodes; p++)
        t->first[t->number[p] + 1]++;
    for (uint32_t n = 0; n < t->count; n++)
        t->first[n + 2] += t->first[n + 1];
    for (uint32_t p = 0; p < nodes; p++)
        t->list[t->first[t->number[p]]++] = p;
    return HATCH_OK;
}

static enum hatch_status allocate(const struct thinning *t, struct hatch_arena *arena, struct hatch_err *err)
{
    struct hatch_curvature_terrain *out = t->coarse;
    size_t nodes = t->count, entries = t->fine->surface.ring_first[t->fine->surface.point_count];
    *out = (struct hatch_curvature_terrain){.surface = {.point_count = t->count}};
    out->first = HATCH_NEW(arena, uint32_t, nodes + 1, err);
    out->points = out->first ? HATCH_NEW_UNSET(arena, uint32_t, t->finest->surface.point_count, err) : NULL;
    out->sides = out->points ? HATCH_NEW_UNSET(arena, int8_t, t->finest->surface.point_count, err) : NULL;
    out->weights = out->sides ? HATCH_NEW_UNSET(arena, double, nodes, err) : NULL;
    out->normals = out->weights ? HATCH_NEW(arena, double, nodes * 3, err) : NULL;
    out->surface.points = out->normals ? HATCH_NEW(arena, double, nodes * 3, err) : NULL;
    out->surface.ring_first = out->surface.points ? HATCH_NEW(arena, uint32_t, nodes + 1, err) : NULL;
    out->surface.ring_point = out->surface.ring_first ? HATCH_NEW_UNSET(arena, uint32_t, entries, err) : NULL;
    out->surface.ring_turned = out->surface.ring_point ? HATCH_NEW_UNSET(arena, uint8_t, entries, err) : NULL;
    return out->surface.ring_turned ? HATCH_OK : HATCH_LIMIT;
}

/* The points that a coarse node stands for, and their means. */
static void fill_node(const struct thinning *t, uint32_t n)
{
    struct hatch_curvature_terrain *out = t->coarse;
    double *place = &out->surface.points[3 * (size_t)n], *normal = &out->normals[3 * (size_t)n];
    uint32_t at = out->first[n];
    for (uint32_t k = t->first[n]; k < t->first[n + 1]; k++) {
        uint32_t p = t->list[k];
        struct hatch_curvature_span own = hatch_curvature_points(t->fine, p);
        for (uint32_t i = own.first; i < own.end; i++, at++) {
            uint32_t q = t->fine->points ? t->fine->points[i] : i;
            out->points[at] = q;
            out->sides[at] = t->fine->sides ? (int8_t)(t->fine->sides[i] * t->side[p]) : t->side[p];
            hatch_vec_add_scaled(place, 1, &t->finest->surface.points[3 * (size_t)q], place);
            hatch_vec_add_scaled(normal, out->sides[at], &t->finest->normals[3 * (size_t)q], normal);
        }
    }
    out->weights[n] = at - out->first[n];
    out->first[n + 1] = at;
    for (int k = 0; k < 3; k++)
        place[k] /= out->weights[n];
    hatch_vec_normalize(normal);
}

static void fill_ring(const struct thinning *t, uint32_t n)
{
    const struct hatch_surface *fine = &t->fine->surface;
    struct hatch_surface *out = &t->coarse->surface;
    uint32_t begin = out->ring_first[n], at = begin;
    for (uint32_t k = t->first[n]; k < t->first[n + 1]; k++)
        for (uint32_t p = t->list[k], i = fine->ring_first[p]; i < fine->ring_first[p + 1]; i++) {
            uint32_t q = fine->ring_point[i], far = t->number[q] - 1;
            if (far == n || (t->slot[far] > begin && t->slot[far] <= at))
                continue;
            out->ring_point[at] = far;
            out->ring_turned[at] = (t->side[p] != t->side[q]) != fine->ring_turned[i];
            t->slot[far] = ++at;
        }
    out->ring_first[n + 1] = at;
}

enum hatch_status hatch_curvature_thin(const struct hatch_curvature_terrain *finest,
                                       const struct hatch_curvature_terrain *fine, struct hatch_arena *arena,
                                       struct hatch_curvature_terrain *coarse, struct hatch_err *err)
{
    struct thinning t = {.finest = finest, .fine = fine, .coarse = coarse};
    t.number = HATCH_NEW(arena, uint32_t, fine->surface.point_count, err);
    t.side = t.number ? HATCH_NEW(arena, int8_t, fine->surface.point_count, err) : NULL;
    if (!t.side)
        return HATCH_LIMIT;
    join_nodes(&t);
    HATCH_TRY(group_nodes(&t, arena, err));
    HATCH_TRY(allocate(&t, arena, err));
    for (uint32_t n = 0; n < t.count; n++) {
        fill_node(&t, n);
        fill_ring(&t, n);
    }
    return HATCH_OK;
}
