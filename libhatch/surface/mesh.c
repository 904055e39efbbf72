#include "mesh/splits.h"
#include "surface/surface.h"

#define KEPT 1u
#define REVERSED 2u

/* Finds whether the faces of each vertex were KEPT, REVERSED or both.
 *   vertex        per corner
 *   orientations  in: zeros; out: per vertex */
static void find_orientations(const struct hatch_surface *s, const struct hatch_mesh *source, const uint32_t *vertex,
                              uint8_t *orientations)
{
    for (uint32_t corner = 0; corner < 3 * s->face_count; corner++) {
        uint32_t face = corner / 3;
        bool reversed = source->indices[(size_t)s->face_source[face] * 3 + 1] != s->corner_vertex[3 * face + 1];
        orientations[vertex[corner]] |= reversed ? REVERSED : KEPT;
    }
}

/* Negates the normals of reversed vertices, and their moves by morph targets. w of a tangent changes sign too, which
 * keeps the bitangent w * (NORMAL × TANGENT), the direction in which v falls. */
static void flip_normals(const uint8_t *orientations, struct hatch_mesh *mesh)
{
    float *normals = hatch_mesh_find(mesh, "NORMAL", 3);
    float *tangents = hatch_mesh_find(mesh, "TANGENT", 4);
    const struct hatch_mesh_attribute *moves = hatch_mesh_attribute(mesh, HATCH_MORPH_NORMAL);
    for (uint32_t v = 0; v < mesh->vertex_count; v++) {
        if (orientations[v] != REVERSED)
            continue;
        for (size_t k = 0; normals && k < 3; k++)
            normals[v * 3 + k] = -normals[v * 3 + k];
        for (size_t k = 0; moves && k < moves->components; k++)
            moves->data[v * moves->components + k] = -moves->data[v * moves->components + k];
        if (normals && tangents)
            tangents[v * 4 + 3] = -tangents[v * 4 + 3];
    }
}

static enum hatch_status build(const struct hatch_surface *s, const struct hatch_mesh *source,
                               struct hatch_arena *arena, struct hatch_arena *scratch, struct hatch_mesh *mesh,
                               uint32_t **vertex_point, struct hatch_err *err)
{
    size_t corners = (size_t)s->face_count * 3;
    struct hatch_splits splits;
    struct hatch_mesh made;
    HATCH_TRY(hatch_splits_make(s->corner_vertex, s->corners, corners, source->vertex_count, scratch, &splits, err));
    uint32_t *number, *point, count = 0;
    HATCH_TRY(HATCH_ALLOC(scratch, &number, splits.count, err));
    HATCH_TRY(HATCH_ALLOC(arena, &point, splits.count, err));
    for (uint32_t v = 0; v < splits.count; v++) {
        if (splits.class_at[v] == HATCH_NO_CLASS)
            continue;
        splits.origin[count] = splits.origin[v];
        point[count] = splits.class_at[v];
        number[v] = count++;
    }
    HATCH_TRY(hatch_mesh_gather(source, splits.origin, count, s->face_count, arena, &made, err));
    for (size_t i = 0; i < corners; i++)
        made.indices[i] = number[splits.indices[i]];
    uint8_t *orientations;
    HATCH_TRY(HATCH_ALLOC(scratch, &orientations, count, err));
    find_orientations(s, source, made.indices, orientations);
    flip_normals(orientations, &made);
    *mesh = made;
    *vertex_point = point;
    return HATCH_OK;
}

enum hatch_status hatch_surface_to_mesh(const struct hatch_surface *surface, const struct hatch_mesh *source,
                                        struct hatch_arena *arena, struct hatch_arena *scratch, struct hatch_mesh *mesh,
                                        uint32_t **vertex_point, struct hatch_err *err)
{
    struct hatch_arena_mark mark = hatch_arena_mark(scratch);
    enum hatch_status status = build(surface, source, arena, scratch, mesh, vertex_point, err);
    hatch_arena_rewind(scratch, mark);
    return status;
}
