#include <assert.h>

#include "lapped/work.h"
#include "math/vector.h"

/* A corner of the patch. Corners that agree in the first three members share a vertex of its mesh. */
struct corner {
    uint32_t vertex;  /* vertex of the patch */
    uint32_t origin;  /* vertex of the source mesh */
    uint32_t flipped; /* 1 if its normal must be flipped */
    uint32_t index;   /* its index among the patch's corners */
};

/* The patch and what its mesh is made from. */
struct patch_source {
    const struct hatch_lapped_input *input;
    const struct hatch_lapped *lapped;
    const struct hatch_lapped_patch *patch;
    float *hatch;           /* 2 per vertex: TEXCOORD_0 */
    struct corner *corners; /* sorted by vertex, origin, flipped, index */
};

/* Returns whether corner a comes before corner b of the same vertex. */
static bool before(const struct corner *a, const struct corner *b)
{
    if (a->origin != b->origin)
        return a->origin < b->origin;
    return a->flipped != b->flipped ? a->flipped < b->flipped : a->index < b->index;
}

static bool same(const struct corner *a, const struct corner *b)
{
    return a->vertex == b->vertex && a->origin == b->origin && a->flipped == b->flipped;
}

/* Returns whether a corner's normal points to the wrong side because the face was reversed in the surface. */
static bool needs_flip(const struct hatch_lapped_input *input, const float *normals, uint32_t face, uint32_t c)
{
    const struct hatch_surface *surface = input->surface;
    const uint32_t *vertex = &surface->corner_vertex[3 * (size_t)face];
    if (!normals || input->mesh->indices[3 * (size_t)surface->face_source[face] + 1] == vertex[1])
        return false;
    const uint32_t *corner = &surface->corners[3 * (size_t)face];
    double own[3], normal[3];
    hatch_vec_of(&normals[3 * (size_t)vertex[c]], own);
    hatch_vec_triangle(&surface->points[3 * (size_t)corner[0]], &surface->points[3 * (size_t)corner[1]],
                       &surface->points[3 * (size_t)corner[2]], normal);
    return hatch_vec_dot(own, normal) < 0;
}

/* Sorts corners by vertex, then by before().
 *   first  vertex_count + 1 zeros, overwritten */
static void sort_corners(const struct corner *corners, uint32_t count, uint32_t vertex_count, uint32_t *first,
                         struct corner *sorted)
{
    for (uint32_t i = 0; i < count; i++)
        first[corners[i].vertex + 1]++;
    for (uint32_t v = 0; v < vertex_count; v++)
        first[v + 1] += first[v];
    /* Filled from the end: first[v + 1] falls to the start of vertex v. */
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

static enum hatch_status list_corners(struct patch_source *from, struct hatch_arena *scratch, struct hatch_err *err)
{
    const struct hatch_lapped_patch *patch = from->patch;
    const float *normals = hatch_mesh_find(from->input->mesh, "NORMAL", 3);
    uint32_t count = 3 * patch->face_count;
    uint32_t *first;
    struct corner *list;
    HATCH_TRY(HATCH_ALLOC(scratch, &first, (size_t)patch->vertex_count + 1, err));
    HATCH_TRY(HATCH_ALLOC_UNSET(scratch, &list, count, err));
    HATCH_TRY(HATCH_ALLOC_UNSET(scratch, &from->corners, count, err));
    for (uint32_t i = 0; i < count; i++) {
        uint32_t face = from->lapped->faces[patch->first_face + i / 3];
        list[i].vertex = from->lapped->corners[3 * (size_t)patch->first_face + i];
        list[i].origin = from->input->surface->corner_vertex[3 * (size_t)face + i % 3];
        list[i].flipped = needs_flip(from->input, normals, face, i % 3);
        list[i].index = i;
    }
    sort_corners(list, count, patch->vertex_count, first, from->corners);
    return HATCH_OK;
}

static void flip(float *normals, float *tangents, uint32_t vertex)
{
    for (size_t k = 0; k < 3; k++)
        normals[3 * (size_t)vertex + k] = -normals[3 * (size_t)vertex + k];
    if (tangents)
        tangents[4 * (size_t)vertex + 3] = -tangents[4 * (size_t)vertex + 3];
}

static enum hatch_status find_or_add(struct hatch_arena *arena, struct hatch_mesh *mesh, const char *name,
                                     uint32_t components, float **data, struct hatch_err *err)
{
    *data = hatch_mesh_find(mesh, name, components);
    return *data ? HATCH_OK : hatch_mesh_add(arena, mesh, name, components, data, err);
}

/* The attributes of the patch's mesh that are not copied. */
struct attributes {
    float *hatch, *mask, *direction, *normals, *tangents;
};

static void write_vertex(const struct patch_source *from, const struct corner *corner, const struct attributes *to,
                         uint32_t vertex)
{
    const struct hatch_lapped_vertex *source = &from->lapped->vertices[from->patch->first_vertex + corner->vertex];
    for (size_t i = 0; i < 2; i++) {
        to->hatch[2 * (size_t)vertex + i] = from->hatch[2 * (size_t)corner->vertex + i];
        to->mask[2 * (size_t)vertex + i] = source->mask[i];
    }
    for (size_t i = 0; i < 3; i++)
        to->direction[4 * (size_t)vertex + i] = (float)from->input->direction[3 * (size_t)source->point + i];
    to->direction[4 * (size_t)vertex + 3] = (float)from->input->confidence[source->point];
    if (corner->flipped)
        flip(to->normals, to->tangents, vertex);
}

static enum hatch_status build(const struct patch_source *from, struct hatch_arena *arena, struct hatch_arena *scratch,
                               struct hatch_mesh *mesh, struct hatch_err *err)
{
    const struct corner *corners = from->corners;
    uint32_t corner_count = 3 * from->patch->face_count, count = 0;
    uint32_t *origin;
    HATCH_TRY(HATCH_ALLOC(scratch, &origin, corner_count, err));
    for (uint32_t i = 0; i < corner_count; i++)
        if (i == 0 || !same(&corners[i - 1], &corners[i]))
            origin[count++] = corners[i].origin;
    struct hatch_mesh made;
    struct attributes to;
    HATCH_TRY(hatch_mesh_gather(from->input->mesh, origin, count, from->patch->face_count, arena, &made, err));
    HATCH_TRY(find_or_add(arena, &made, "TEXCOORD_0", 2, &to.hatch, err));
    HATCH_TRY(find_or_add(arena, &made, "TEXCOORD_1", 2, &to.mask, err));
    HATCH_TRY(find_or_add(arena, &made, "_HATCH_DIR", 4, &to.direction, err));
    to.normals = hatch_mesh_find(&made, "NORMAL", 3);
    to.tangents = hatch_mesh_find(&made, "TANGENT", 4);
    uint32_t vertex = 0;
    for (uint32_t i = 0; i < corner_count; i++) {
        bool first = i == 0 || !same(&corners[i - 1], &corners[i]);
        vertex += first && i > 0;
        made.indices[corners[i].index] = vertex;
        if (first)
            write_vertex(from, &corners[i], &to, vertex);
    }
    *mesh = made;
    return HATCH_OK;
}

enum hatch_status hatch_lapped_mesh(const struct hatch_lapped_input *input, const struct hatch_lapped *lapped,
                                    uint32_t patch, struct hatch_arena *arena, struct hatch_arena *scratch,
                                    struct hatch_mesh *mesh, struct hatch_err *err)
{
    assert(patch < lapped->patch_count && input->tile > 0);
    struct patch_source from = {.input = input, .lapped = lapped, .patch = &lapped->patches[patch]};
    struct hatch_arena_mark mark = hatch_arena_mark(scratch);
    from.hatch = HATCH_NEW_UNSET(scratch, float, 2 * (size_t)from.patch->vertex_count, err);
    enum hatch_status status =
        from.hatch ? hatch_lapped_round(lapped, from.patch, input->tile, scratch, from.hatch, err) : HATCH_LIMIT;
    if (status == HATCH_OK)
        status = list_corners(&from, scratch, err);
    if (status == HATCH_OK)
        status = build(&from, arena, scratch, mesh, err);
    hatch_arena_rewind(scratch, mark);
    return status;
}
