#include "math/vector.h"
#include "curvature/work.h"

#define GROUP_MAX 2u          /* fine nodes per coarse node */
#define NORMAL_COSINE_MIN 0.7 /* between their normals: the mean of both sides of a sharp edge lies off the surface */

struct coarsening {
    const struct hatch_curvature_graph *finest, *fine;
    struct hatch_curvature_graph *coarse;
    uint32_t count;         /* of coarse nodes */
    uint32_t *group;        /* per fine node: its coarse node plus 1; 0: none yet */
    int8_t *side;           /* per fine node: -1 where its outside is not that of the coarse node, else 1 */
    uint32_t *first, *list; /* fine nodes of coarse node n: list[first[n]] .. list[first[n + 1] - 1] */
    uint32_t *slot;         /* per coarse node: its entry in the ring being built, plus 1 */
};

/* Adds the nearest neighbour without a group to the current one. Returns false when there is none. */
static bool add_nearest(struct coarsening *c, uint32_t p)
{
    const struct hatch_surface *fine = &c->fine->surface;
    const double *normals = c->fine->normals;
    double least = INFINITY;
    uint32_t best = 0;
    for (uint32_t i = fine->ring_first[p]; i < fine->ring_first[p + 1]; i++) {
        uint32_t q = fine->ring_point[i];
        if (c->group[q])
            continue;
        double cosine = hatch_vec_dot(&normals[3 * (size_t)p], &normals[3 * (size_t)q]);
        double length = hatch_vec_distance(&fine->points[3 * (size_t)p], &fine->points[3 * (size_t)q]);
        if ((fine->ring_turned[i] ? -cosine : cosine) < NORMAL_COSINE_MIN || !(length < least))
            continue;
        least = length;
        best = i;
    }
    if (!(least < INFINITY))
        return false;
    c->group[fine->ring_point[best]] = c->count;
    c->side[fine->ring_point[best]] = fine->ring_turned[best] ? -1 : 1;
    return true;
}

static void choose_groups(struct coarsening *c)
{
    for (uint32_t p = 0; p < c->fine->surface.point_count; p++) {
        if (c->group[p])
            continue;
        c->group[p] = ++c->count;
        c->side[p] = 1;
        for (uint32_t more = 1; more < GROUP_MAX && add_nearest(c, p); more++)
            ;
    }
}

static enum hatch_status sort_by_group(struct coarsening *c, struct hatch_arena *arena, struct hatch_err *err)
{
    uint32_t nodes = c->fine->surface.point_count;
    HATCH_TRY(HATCH_ALLOC(arena, &c->first, (size_t)c->count + 2, err));
    HATCH_TRY(HATCH_ALLOC_UNSET(arena, &c->list, nodes, err));
    HATCH_TRY(HATCH_ALLOC(arena, &c->slot, c->count, err));
    for (uint32_t p = 0; p < nodes; p++)
        c->first[c->group[p] + 1]++;
    for (uint32_t n = 0; n < c->count; n++)
        c->first[n + 2] += c->first[n + 1];
    for (uint32_t p = 0; p < nodes; p++)
        c->list[c->first[c->group[p]]++] = p;
    return HATCH_OK;
}

static enum hatch_status allocate(const struct coarsening *c, struct hatch_arena *arena, struct hatch_err *err)
{
    struct hatch_curvature_graph *out = c->coarse;
    size_t nodes = c->count, entries = c->fine->surface.ring_first[c->fine->surface.point_count];
    *out = (struct hatch_curvature_graph){.surface = {.point_count = c->count,
                                                      .component_count = c->fine->surface.component_count,
                                                      .components = c->fine->surface.components},
                                          .parent = c->group,
                                          .parent_side = c->side};
    HATCH_TRY(HATCH_ALLOC(arena, &out->first, nodes + 1, err));
    HATCH_TRY(HATCH_ALLOC_UNSET(arena, &out->points, c->finest->surface.point_count, err));
    HATCH_TRY(HATCH_ALLOC_UNSET(arena, &out->sides, c->finest->surface.point_count, err));
    HATCH_TRY(HATCH_ALLOC_UNSET(arena, &out->weights, nodes, err));
    HATCH_TRY(HATCH_ALLOC(arena, &out->normals, nodes * 3, err));
    HATCH_TRY(HATCH_ALLOC(arena, &out->surface.points, nodes * 3, err));
    HATCH_TRY(HATCH_ALLOC_UNSET(arena, &out->surface.point_component, nodes, err));
    HATCH_TRY(HATCH_ALLOC(arena, &out->surface.ring_first, nodes + 1, err));
    HATCH_TRY(HATCH_ALLOC_UNSET(arena, &out->surface.ring_point, entries, err));
    return HATCH_ALLOC_UNSET(arena, &out->surface.ring_turned, entries, err);
}

/* Sets the component of a coarse node, lists its points and computes their means. */
static void fill_node(const struct coarsening *c, uint32_t n)
{
    struct hatch_curvature_graph *out = c->coarse;
    double *position = &out->surface.points[3 * (size_t)n], *normal = &out->normals[3 * (size_t)n];
    uint32_t at = out->first[n];
    out->surface.point_component[n] = c->fine->surface.point_component[c->list[c->first[n]]];
    for (uint32_t k = c->first[n]; k < c->first[n + 1]; k++) {
        uint32_t p = c->list[k];
        struct hatch_curvature_members own = hatch_curvature_node_members(c->fine, p);
        for (uint32_t i = own.first; i < own.end; i++, at++) {
            uint32_t q = c->fine->points ? c->fine->points[i] : i;
            out->points[at] = q;
            out->sides[at] = c->fine->sides ? (int8_t)(c->fine->sides[i] * c->side[p]) : c->side[p];
            hatch_vec_add_scaled(position, 1, &c->finest->surface.points[3 * (size_t)q], position);
            hatch_vec_add_scaled(normal, out->sides[at], &c->finest->normals[3 * (size_t)q], normal);
        }
    }
    out->weights[n] = at - out->first[n];
    out->first[n + 1] = at;
    for (int k = 0; k < 3; k++)
        position[k] /= out->weights[n];
    hatch_vec_normalize(normal);
}

static void fill_ring(const struct coarsening *c, uint32_t n)
{
    const struct hatch_surface *fine = &c->fine->surface;
    struct hatch_surface *out = &c->coarse->surface;
    uint32_t begin = out->ring_first[n], at = begin;
    for (uint32_t k = c->first[n]; k < c->first[n + 1]; k++)
        for (uint32_t p = c->list[k], i = fine->ring_first[p]; i < fine->ring_first[p + 1]; i++) {
            uint32_t q = fine->ring_point[i], neighbour = c->group[q] - 1;
            if (neighbour == n || (c->slot[neighbour] > begin && c->slot[neighbour] <= at))
                continue;
            out->ring_point[at] = neighbour;
            out->ring_turned[at] = (c->side[p] != c->side[q]) != fine->ring_turned[i];
            c->slot[neighbour] = ++at;
        }
    out->ring_first[n + 1] = at;
}

enum hatch_status hatch_curvature_graph_coarsen(const struct hatch_curvature_graph *finest,
                                                const struct hatch_curvature_graph *fine, struct hatch_arena *arena,
                                                struct hatch_curvature_graph *coarse, struct hatch_err *err)
{
    struct coarsening c = {.finest = finest, .fine = fine, .coarse = coarse};
    HATCH_TRY(HATCH_ALLOC(arena, &c.group, fine->surface.point_count, err));
    HATCH_TRY(HATCH_ALLOC(arena, &c.side, fine->surface.point_count, err));
    choose_groups(&c);
    HATCH_TRY(sort_by_group(&c, arena, err));
    HATCH_TRY(allocate(&c, arena, err));
    for (uint32_t n = 0; n < c.count; n++) {
        fill_node(&c, n);
        fill_ring(&c, n);
    }
    for (uint32_t p = 0; p < fine->surface.point_count; p++)
        coarse->parent[p]--; /* from numbers from 1 */
    return HATCH_OK;
}
