#include "measure/mesh_figures.h"

#include <string.h>

#include "math/percentile.h"
#include "math/vector.h"
#include "measure/stretch.h"
#include "mesh/dropped.h"
#include "mesh/fans.h"

struct work {
    const struct hatch_mesh *mesh;
    struct hatch_arena *scratch;
    struct hatch_mesh_figures *out;
    uint32_t *point;     /* per corner: its point */
    uint8_t *dropped;    /* per face: 1 if degenerate */
    uint8_t *point_used; /* per point: 1 if a face that is not degenerate uses it */
    uint32_t *sets;      /* per point: disjoint sets of points */
    struct hatch_edges edges;
};

static void find_used(struct work *w, uint8_t *vertex_used)
{
    const struct hatch_mesh *mesh = w->mesh;
    double corners[3][3], normal[3];
    w->out->degenerate_faces = hatch_mesh_find_degenerate(mesh, w->point, w->dropped);
    for (uint32_t f = 0; f < mesh->face_count; f++) {
        const uint32_t *p = &w->point[(size_t)f * 3];
        for (int c = 0; c < 3; c++)
            vertex_used[mesh->indices[(size_t)f * 3 + (size_t)c]] = 1;
        if (w->dropped[f])
            continue;
        for (int c = 0; c < 3; c++)
            w->point_used[p[c]] = 1;
        hatch_mesh_corners(mesh, f, corners);
        hatch_vec_triangle(corners[0], corners[1], corners[2], normal);
        w->out->area += hatch_vec_length(normal) / 2;
    }
    for (uint32_t v = 0; v < mesh->vertex_count; v++)
        w->out->unused_vertices += !vertex_used[v];
}

static uint32_t count_sets(const struct work *w, const uint8_t *member)
{
    uint32_t count = 0;
    for (uint32_t p = 0; p < w->out->points; p++)
        count += member[p] && w->sets[p] == p;
    return count;
}

static void side_ends(const struct work *w, uint32_t edge, uint32_t *a, uint32_t *b)
{
    uint32_t side = w->edges.sides[w->edges.first[edge]];
    *a = w->point[side];
    *b = w->point[hatch_side_end(side)];
}

static void find_components(struct work *w)
{
    uint32_t a, b;
    hatch_sets_init(w->sets, w->out->points);
    for (uint32_t e = 0; e < w->edges.count; e++) {
        side_ends(w, e, &a, &b);
        hatch_sets_join(w->sets, a, b);
    }
    w->out->components = count_sets(w, w->point_used);
}

/* Counts boundary loops, non-manifold edges and contrary edges.
 *   on_boundary  scratch: zeros, one per point */
static void find_boundary(struct work *w, uint8_t *on_boundary)
{
    uint32_t a, b;
    hatch_sets_init(w->sets, w->out->points);
    for (uint32_t e = 0; e < w->edges.count; e++) {
        uint32_t faces = w->edges.first[e + 1] - w->edges.first[e];
        const uint32_t *sides = &w->edges.sides[w->edges.first[e]];
        w->out->non_manifold_edges += faces > 2;
        w->out->contrary_edges += faces == 2 && w->point[sides[0]] == w->point[sides[1]];
        if (faces != 1)
            continue;
        side_ends(w, e, &a, &b);
        on_boundary[a] = on_boundary[b] = 1;
        hatch_sets_join(w->sets, a, b);
    }
    w->out->boundary_loops = count_sets(w, on_boundary);
}

static void find_genus(struct work *w)
{
    struct hatch_mesh_figures *out = w->out;
    int64_t used = 0;
    for (uint32_t p = 0; p < out->points; p++)
        used += w->point_used[p];
    int64_t faces = (int64_t)out->faces - out->degenerate_faces;
    out->euler = used - (int64_t)w->edges.count + faces;
    bool surface = out->non_manifold_edges == 0 && out->non_manifold_points == 0 && out->contrary_edges == 0;
    out->genus = surface ? (2 * (int64_t)out->components - out->euler - (int64_t)out->boundary_loops) / 2 : -1;
}

static void measure_edges(struct work *w)
{
    const float *positions = w->mesh->attributes[0].data;
    double sum = 0, a[3], b[3];
    w->out->edge_min = w->out->edge_mean = w->out->edge_max = NAN;
    for (uint32_t e = 0; e < w->edges.count; e++) {
        uint32_t side = w->edges.sides[w->edges.first[e]];
        hatch_vec_of(&positions[(size_t)w->mesh->indices[side] * 3], a);
        hatch_vec_of(&positions[(size_t)w->mesh->indices[hatch_side_end(side)] * 3], b);
        double length = hatch_vec_distance(a, b);
        sum += length;
        w->out->edge_min = fmin(w->out->edge_min, length); /* fmin and fmax ignore NaN */
        w->out->edge_max = fmax(w->out->edge_max, length);
        w->out->edge_mean = sum / (e + 1);
    }
}

static enum hatch_status measure_uv(struct work *w, struct hatch_err *err)
{
    const float *uv = hatch_mesh_find(w->mesh, "TEXCOORD_0", 2);
    struct hatch_uv_figures *out = &w->out->uv;
    w->out->has_uv = uv != NULL;
    if (!uv)
        return HATCH_OK;
    static const double shares[3] = {0.05, 0.5, 0.95};
    struct hatch_stretch *list;
    struct hatch_weighted *values;
    HATCH_TRY(HATCH_ALLOC(w->scratch, &list, w->mesh->face_count, err));
    HATCH_TRY(HATCH_ALLOC(w->scratch, &values, w->mesh->face_count, err));
    double kept = 0, degenerate = 0, mirrored = 0, uv_area = 0;
    uint32_t count = 0;
    for (uint32_t f = 0; f < w->mesh->face_count; f++) {
        struct hatch_stretch *s = &list[count];
        if (!hatch_measure_stretch(w->mesh, uv, f, s))
            continue;
        if (!(fabs(s->uv_area) > 0) || !isfinite(s->ratio)) {
            degenerate += s->area;
            continue;
        }
        kept += s->area;
        /* v points down the texture, so that an unmirrored triangle has negative area in u and v. */
        mirrored += s->uv_area > 0 ? s->area : 0;
        uv_area += fabs(s->uv_area);
        count++;
    }
    out->degenerate_share = kept + degenerate > 0 ? degenerate / (kept + degenerate) : NAN;
    out->mirrored_share = kept > 0 ? mirrored / kept : NAN;
    for (uint32_t i = 0; i < count; i++)
        values[i] = (struct hatch_weighted){list[i].ratio, list[i].area};
    hatch_percentiles(values, count, shares, 3, out->angle);
    for (uint32_t i = 0; i < count; i++)
        values[i] = (struct hatch_weighted){fabs(list[i].uv_area) / list[i].area * (kept / uv_area), list[i].area};
    hatch_percentiles(values, count, shares, 3, out->area);
    return HATCH_OK;
}

static enum hatch_status measure(struct work *w, struct hatch_err *err)
{
    const struct hatch_mesh *mesh = w->mesh;
    struct hatch_mesh_figures *out = w->out;
    struct hatch_arena *scratch = w->scratch;
    uint32_t *vertex_to_point;
    uint8_t *flags;
    HATCH_TRY(HATCH_ALLOC(scratch, &vertex_to_point, mesh->vertex_count, err));
    HATCH_TRY(HATCH_ALLOC(scratch, &flags, mesh->vertex_count, err));
    HATCH_TRY(HATCH_ALLOC(scratch, &w->point, (size_t)mesh->face_count * 3, err));
    HATCH_TRY(HATCH_ALLOC(scratch, &w->dropped, mesh->face_count, err));
    HATCH_TRY(HATCH_ALLOC(scratch, &w->point_used, mesh->vertex_count, err));
    HATCH_TRY(HATCH_ALLOC(scratch, &w->sets, mesh->vertex_count, err));
    HATCH_TRY(hatch_mesh_weld(mesh, scratch, vertex_to_point, &out->points, err));
    hatch_mesh_corner_points(mesh, vertex_to_point, w->point);
    find_used(w, flags);
    const struct hatch_connectivity faces = {w->point, mesh->face_count, out->points, w->dropped};
    HATCH_TRY(hatch_edges_find(&faces, scratch, scratch, &w->edges, err));
    HATCH_TRY(hatch_mesh_count_pinched(&faces, &w->edges, scratch, &out->non_manifold_points, err));
    find_components(w);
    memset(flags, 0, mesh->vertex_count);
    find_boundary(w, flags);
    find_genus(w);
    measure_edges(w);
    hatch_mesh_bounds(mesh, out->low, out->high);
    struct hatch_mesh_duplicates duplicates;
    HATCH_TRY(hatch_mesh_find_duplicates(w->point, mesh->face_count, w->dropped, scratch, &duplicates, err));
    out->duplicate_faces = duplicates.count;
    return measure_uv(w, err);
}

enum hatch_status hatch_measure_mesh(const struct hatch_mesh *mesh, struct hatch_arena *scratch,
                                     struct hatch_mesh_figures *figures, struct hatch_err *err)
{
    struct hatch_arena_mark mark = hatch_arena_mark(scratch);
    struct hatch_mesh_figures made = {.vertices = mesh->vertex_count, .faces = mesh->face_count};
    struct work w = {.mesh = mesh, .scratch = scratch, .out = &made};
    enum hatch_status status = measure(&w, err);
    hatch_arena_rewind(scratch, mark);
    if (status == HATCH_OK)
        *figures = made;
    return status;
}
