#include <assert.h>

#include "lapped/work.h"

/* A corner of the patch. Corners that agree in the first two members share a vertex of its mesh. */
struct corner {
    uint32_t vertex; /* vertex of the patch */
    uint32_t origin; /* vertex of the source mesh */
    uint32_t index;  /* its index among the patch's corners */
};

/* The patch and what its mesh is made from. */
struct patch_source {
    const struct hatch_lapped_input *input;
    const struct hatch_lapped *lapped;
    const struct hatch_lapped_patch *patch;
    float *hatch;           /* 2 per vertex: TEXCOORD_0 */
    struct corner *corners; /* sorted by vertex, origin, index */
};

/* Returns whether corner a comes before corner b of the same vertex. */
static bool before(const struct corner *a, const struct corner *b)
{
    return a->origin != b->origin ? a->origin < b->origin : a->index < b->index;
}

static bool same(const struct corner *a, const struct corner *b)
{
    return a->vertex == b->vertex && a->origin == b->origin;
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
        list[i].index = i;
    }
    sort_corners(list, count, patch->vertex_count, first, from->corners);
    return HATCH_OK;
}

static enum hatch_status find_or_add(struct hatch_arena *arena, struct hatch_mesh *mesh, const char *name,
                                     uint32_t components, float **data, struct hatch_err *err)
{
    *data = hatch_mesh_find(mesh, name, components);
    return *data ? HATCH_OK : hatch_mesh_add(arena, mesh, name, components, data, err);
}

/* The attributes of the patch's mesh that are not copied. */
struct attributes {
    float *hatch, *mask, *direction;
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
