#include "scene/uv_charts.h"

#include <stdlib.h>

#include "mesh/fans.h"

/* A vertex, to be sorted by point and texture coordinates. */
struct texture_vertex {
    uint32_t point, vertex;
    float u, v;
};

static int compare_vertices(const void *a, const void *b)
{
    const struct texture_vertex *x = a, *y = b;
    if (x->point != y->point)
        return x->point < y->point ? -1 : 1;
    if (x->u < y->u || x->u > y->u)
        return x->u < y->u ? -1 : 1;
    return (x->v > y->v) - (x->v < y->v);
}

enum hatch_status hatch_uv_charts_join(const struct hatch_mesh *mesh, const float *texcoord,
                                       struct hatch_arena *scratch, uint32_t *parent, struct hatch_err *err)
{
    struct hatch_arena_mark mark = hatch_arena_mark(scratch);
    uint32_t point_count;
    uint32_t *points;
    struct texture_vertex *sorted;
    HATCH_TRY(HATCH_ALLOC(scratch, &points, mesh->vertex_count, err));
    HATCH_TRY(HATCH_ALLOC(scratch, &sorted, mesh->vertex_count, err));
    HATCH_TRY(hatch_mesh_weld(mesh, scratch, points, &point_count, err));
    hatch_sets_init(parent, mesh->vertex_count);
    for (uint32_t v = 0; v < mesh->vertex_count; v++) {
        sorted[v] = (struct texture_vertex){points[v], v, texcoord[2 * (size_t)v], texcoord[2 * (size_t)v + 1]};
    }
    qsort(sorted, mesh->vertex_count, sizeof *sorted, compare_vertices);
    for (uint32_t i = 1; i < mesh->vertex_count; i++)
        if (compare_vertices(&sorted[i - 1], &sorted[i]) == 0)
            hatch_sets_join(parent, sorted[i - 1].vertex, sorted[i].vertex);
    for (size_t i = 0; i < 3 * (size_t)mesh->face_count; i += 3) {
        hatch_sets_join(parent, mesh->indices[i], mesh->indices[i + 1]);
        hatch_sets_join(parent, mesh->indices[i], mesh->indices[i + 2]);
    }
    hatch_arena_rewind(scratch, mark);
    return HATCH_OK;
}
