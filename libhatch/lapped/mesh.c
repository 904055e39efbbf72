#include <assert.h>
#include <string.h>

#include "lapped/work.h"
#include "math/vector.h"

/* What makes corners one vertex of the patch's mesh. */
struct corner {
    uint32_t vertex; /* of the patch */
    uint32_t origin; /* of the source */
    uint32_t turned; /* its normal looks to the other side of the face */
    uint32_t index;  /* where it stands */
};

/* Among those of one vertex. */
static bool before(const struct corner *a, const struct corner *b)
{
    if (a->origin != b->origin)
        return a->origin < b->origin;
    return a->turned != b->turned ? a->turned < b->turned : a->index < b->index;
}

static bool same(const struct corner *a, const struct corner *b)
{
    return a->vertex == b->vertex && a->origin == b->origin && a->turned == b->turned;
}

/* A face that was turned to agree with its neighbours has its normals on the wrong side. */
static bool looks_away(const struct hatch_surface *surface, const struct hatch_mesh *source, const float *normals,
                       uint32_t face, uint32_t c)
{
    const uint32_t *vertex = &surface->corner_vertex[3 * (size_t)face];
    if (!normals || source->indices[3 * (size_t)surface->face_source[face] + 1] == vertex[1])
        return false;
    const uint32_t *corner = &surface->corners[3 * (size_t)face];
    double own[3], normal[3];
    hatch_vec_of(&normals[3 * (size_t)vertex[c]], own);
    hatch_vec_triangle(&surface->points[3 * (size_t)corner[0]], &surface->points[3 * (size_t)corner[1]],
                       &surface->points[3 * (size_t)corner[2]], normal);
    return hatch_vec_dot(own, normal) < 0;
}

/* By vertex, and then in their order; first: for each vertex and one more, zeros. */
static void sort_corners(const struct corner *corners, uint32_t count, uint32_t vertex_count, uint32_t *first,
                         struct corner *sorted)
{
    for (uint32_t i = 0; i < count; i++)
        first[corners[i].vertex + 1]++;
    for (uint32_t v = 0; v < vertex_count; v++)
        first[v + 1] += first[v];
    /* Filled from behind: each vertex's place falls to where it begins. */
    for (uint32_t i = count; i-- > 0;)
        sorted[--first[corners[i].vertex + 1]] = corners[i];
    for (uint32_t i = 1; i < count; i++) {
        struct corner corner = sorted[i];
        uint32_t at = i;
        for (; at > 0 && sorted[at - 1].vertex == corner.vertex && before(&corner, &sorted[at - 1]); at--)
            sorted[at] = sorted[at - 1];
        sorted[at] = corner;
    }
}

static enum hatch_status list_corners(const struct hatch_surface *surface, const struct hatch_mesh *source,
                                      const struct hatch_lapped *lapped, const struct hatch_lapped_patch *patch,
                                      struct hatch_arena *scratch, struct corner **corners, struct hatch_err *err)
{
    const float *normals = hatch_mesh_find(source, "NORMAL", 3);
    uint32_t count = 3 * patch->face_count;
    uint32_t *first = HATCH_NEW(scratch, uint32_t, (size_t)patch->vertex_count + 1, err);
    struct corner *list = first ? HATCH_NEW_UNSET(scratch, struct corner, count, err) : NULL;
    struct corner *sorted = list ? HATCH_NEW_UNSET(scratch, struct corner, count, err) : NULL;
    if (!sorted)
        return HATCH_LIMIT;
    for (uint32_t i = 0; i < count; i++) {
        uint32_t face = lapped->faces[patch->first_face + i / 3];
        list[i].vertex = lapped->corners[3 * (size_t)patch->first_face + i];
        list[i].origin = surface->corner_vertex[3 * (size_t)face + i % 3];
        list[i].turned = looks_away(surface, source, normals, face, i % 3);
        list[i].index = i;
    }
    sort_corners(list, count, patch->vertex_count, first, sorted);
    *corners = sorted;
    return HATCH_OK;
}

static void turn(float *normals, float *tangents, uint32_t vertex)
{
    for (size_t k = 0; k < 3; k++)
        normals[3 * (size_t)vertex + k] = -normals[3 * (size_t)vertex + k];
    if (tangents)
        tangents[4 * (size_t)vertex + 3] = -tangents[4 * (size_t)vertex + 3];
}

static enum hatch_status room_for(struct hatch_arena *arena, struct hatch_mesh *mesh, const char *name,
                                  uint32_t components, float **data, struct hatch_err *err)
{
    *data = hatch_mesh_find(mesh, name, components);
    return *data ? HATCH_OK : hatch_mesh_add(arena, mesh, name, components, data, err);
}

/* What the patch gives its vertices. */
struct given {
    float *hatch, *mask, *direction, *normals, *tangents;
};

static void give(const struct hatch_lapped_vertex *from, const float hatch[2], const double *direction,
                 const double *confidence, const struct given *to, uint32_t vertex)
{
    for (size_t i = 0; i < 2; i++) {
        to->hatch[2 * (size_t)vertex + i] = hatch[i];
        to->mask[2 * (size_t)vertex + i] = from->mask[i];
    }
    for (size_t i = 0; i < 3; i++)
        to->direction[4 * (size_t)vertex + i] = (float)direction[3 * (size_t)from->point + i];
    to->direction[4 * (size_t)vertex + 3] = (float)confidence[from->point];
}

static enum hatch_status build(const struct hatch_mesh *source, const struct hatch_lapped_patch *patch,
                               const struct hatch_lapped_vertex *vertices, const struct corner *corners,
                               const float *hatch, const double *direction, const double *confidence,
                               struct hatch_arena *arena, struct hatch_arena *scratch, struct hatch_mesh *mesh,
                               struct hatch_err *err)
{
    uint32_t *origin = HATCH_NEW(scratch, uint32_t, 3 * (size_t)patch->face_count, err), count = 0;
    if (!origin)
        return HATCH_LIMIT;
    for (uint32_t i = 0; i < 3 * patch->face_count; i++)
        if (i == 0 || !same(&corners[i - 1], &corners[i]))
            origin[count++] = corners[i].origin;
    struct hatch_mesh made;
    struct given given;
    HATCH_TRY(hatch_mesh_gather(source, origin, count, patch->face_count, arena, &made, err));
    HATCH_TRY(room_for(arena, &made, "TEXCOORD_0", 2, &given.hatch, err));
    HATCH_TRY(room_for(arena, &made, "TEXCOORD_1", 2, &given.mask, err));
    HATCH_TRY(room_for(arena, &made, "_HATCH_DIR", 4, &given.direction, err));
    given.normals = hatch_mesh_find(&made, "NORMAL", 3);
    given.tangents = hatch_mesh_find(&made, "TANGENT", 4);
    uint32_t vertex = 0;
    for (uint32_t i = 0; i < 3 * patch->face_count; i++) {
        bool first = i == 0 || !same(&corners[i - 1], &corners[i]);
        vertex += first && i > 0;
        made.indices[corners[i].index] = vertex;
        if (first)
            give(&vertices[corners[i].vertex], &hatch[2 * (size_t)corners[i].vertex], direction, confidence, &given,
                 vertex);
        if (first && corners[i].turned)
            turn(given.normals, given.tangents, vertex);
    }
    *mesh = made;
    return HATCH_OK;
}

enum hatch_status hatch_lapped_mesh(const struct hatch_surface *surface, const struct hatch_mesh *source,
                                    const struct hatch_lapped *lapped, uint32_t patch, const double *direction,
                                    const double *confidence, double tile, struct hatch_arena *arena,
                                    struct hatch_arena *scratch, struct hatch_mesh *mesh, struct hatch_err *err)
{
    assert(patch < lapped->patch_count && tile > 0);
    const struct hatch_lapped_patch *from = &lapped->patches[patch];
    struct hatch_arena_mark mark = hatch_arena_mark(scratch);
    struct corner *corners;
    float *hatch = HATCH_NEW_UNSET(scratch, float, 2 * (size_t)from->vertex_count, err);
    enum hatch_status status = hatch ? hatch_lapped_round(lapped, from, tile, scratch, hatch, err) : HATCH_LIMIT;
    if (status == HATCH_OK)
        status = list_corners(surface, source, lapped, from, scratch, &corners, err);
    if (status == HATCH_OK)
        status = build(source, from, &lapped->vertices[from->first_vertex], corners, hatch, direction, confidence,
                       arena, scratch, mesh, err);
    hatch_arena_rewind(scratch, mark);
    return status;
}
