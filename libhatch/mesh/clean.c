/* Cleans a mesh. Faces are compared by points (welded positions), so that a mesh whose vertices are not shared is
 * treated as the surface that it looks like. Vertices are not joined; only those that no face uses are dropped. */

#include "mesh/dropped.h"
#include "mesh/fans.h"
#include "mesh/orient.h"

struct work {
    const struct hatch_mesh *mesh;
    uint32_t *point; /* per corner: its point */
    uint32_t point_count;
    uint8_t *dropped; /* per face */
    uint8_t *flipped; /* per face */
    struct hatch_mesh_notes notes;
};

static enum hatch_status orient(struct work *w, struct hatch_arena *scratch, struct hatch_err *err)
{
    const struct hatch_connectivity faces = {w->point, w->mesh->face_count, w->point_count, w->dropped};
    struct hatch_edges edges;
    HATCH_TRY(hatch_edges_find(&faces, scratch, scratch, &edges, err));
    uint32_t *partner;
    HATCH_TRY(HATCH_ALLOC(scratch, &partner, (size_t)w->mesh->face_count * 3, err));
    hatch_edges_partners(&edges, NULL, w->mesh->face_count, partner);
    struct hatch_orientation result = {.flipped = w->flipped};
    HATCH_TRY(hatch_mesh_orient(w->mesh, &faces, partner, scratch, &result, err));
    w->notes.faces_flipped = result.faces_flipped;
    w->notes.contrary_edges = result.contrary_edges;
    for (uint32_t e = 0; e < edges.count; e++)
        w->notes.non_manifold_edges += edges.first[e + 1] - edges.first[e] > 2;
    return hatch_mesh_count_pinched(&faces, &edges, scratch, &w->notes.non_manifold_points, err);
}

/* Numbers the vertices that faces use; returns how many there are.
 *   new_vertex  in: zeros; out: per old vertex, its new index
 *   origin      out: per new vertex, the old one */
static uint32_t number_vertices(const struct work *w, uint32_t *new_vertex, uint32_t *origin)
{
    const struct hatch_mesh *mesh = w->mesh;
    for (size_t i = 0; i < (size_t)mesh->face_count * 3; i++)
        if (!w->dropped[i / 3])
            new_vertex[mesh->indices[i]] = 1;
    uint32_t count = 0;
    for (uint32_t v = 0; v < mesh->vertex_count; v++) {
        if (!new_vertex[v])
            continue;
        origin[count] = v;
        new_vertex[v] = count++;
    }
    return count;
}

static void copy_faces(const struct work *w, const uint32_t *new_vertex, uint32_t *to)
{
    for (uint32_t f = 0; f < w->mesh->face_count; f++) {
        if (w->dropped[f])
            continue;
        const uint32_t *from = &w->mesh->indices[(size_t)f * 3];
        for (int c = 0; c < 3; c++)
            *to++ = new_vertex[from[w->flipped[f] ? (3 - c) % 3 : c]];
    }
}

static enum hatch_status build(struct work *w, struct hatch_arena *arena, struct hatch_arena *scratch,
                               struct hatch_mesh *out, struct hatch_err *err)
{
    const struct hatch_mesh *mesh = w->mesh;
    uint32_t faces = mesh->face_count - w->notes.degenerate_dropped - w->notes.duplicates_dropped;
    if (faces == 0)
        return hatch_fail(err, HATCH_BAD_INPUT, "no face has an area");
    uint32_t *new_vertex, *origin;
    HATCH_TRY(HATCH_ALLOC(scratch, &new_vertex, mesh->vertex_count, err));
    HATCH_TRY(HATCH_ALLOC(scratch, &origin, mesh->vertex_count, err));
    uint32_t vertices = number_vertices(w, new_vertex, origin);
    w->notes.unreferenced_dropped = mesh->vertex_count - vertices;
    HATCH_TRY(hatch_mesh_gather(mesh, origin, vertices, faces, arena, out, err));
    copy_faces(w, new_vertex, out->indices);
    return HATCH_OK;
}

static enum hatch_status clean(struct work *w, struct hatch_arena *arena, struct hatch_arena *scratch,
                               struct hatch_mesh *out, struct hatch_err *err)
{
    const struct hatch_mesh *mesh = w->mesh;
    size_t corners = (size_t)mesh->face_count * 3;
    uint32_t *vertex_to_point;
    HATCH_TRY(HATCH_ALLOC(scratch, &vertex_to_point, mesh->vertex_count, err));
    HATCH_TRY(HATCH_ALLOC(scratch, &w->point, corners, err));
    HATCH_TRY(HATCH_ALLOC(scratch, &w->dropped, mesh->face_count, err));
    HATCH_TRY(HATCH_ALLOC(scratch, &w->flipped, mesh->face_count, err));
    HATCH_TRY(hatch_mesh_weld(mesh, scratch, vertex_to_point, &w->point_count, err));
    if (mesh->attribute_count == 1) /* vertices at one position may differ in other attributes */
        w->notes.vertices_apart = mesh->vertex_count - w->point_count;
    hatch_mesh_corner_points(mesh, vertex_to_point, w->point);
    w->notes.degenerate_dropped = hatch_mesh_find_degenerate(mesh, w->point, w->dropped);
    struct hatch_mesh_duplicates duplicates;
    HATCH_TRY(hatch_mesh_find_duplicates(w->point, mesh->face_count, w->dropped, scratch, &duplicates, err));
    w->notes.duplicates_dropped = duplicates.count;
    HATCH_TRY(orient(w, scratch, err));
    return build(w, arena, scratch, out, err);
}

enum hatch_status hatch_mesh_clean(struct hatch_arena *arena, struct hatch_arena *scratch, struct hatch_mesh *mesh,
                                   struct hatch_mesh_notes *notes, struct hatch_err *err)
{
    struct hatch_arena_mark mark = hatch_arena_mark(scratch);
    struct work w = {.mesh = mesh};
    struct hatch_mesh out;
    enum hatch_status status = clean(&w, arena, scratch, &out, err);
    hatch_arena_rewind(scratch, mark);
    HATCH_TRY(status);
    notes->degenerate_dropped += w.notes.degenerate_dropped;
    notes->duplicates_dropped += w.notes.duplicates_dropped;
    notes->unreferenced_dropped += w.notes.unreferenced_dropped;
    notes->faces_flipped += w.notes.faces_flipped;
    notes->vertices_apart += w.notes.vertices_apart;
    notes->non_manifold_points += w.notes.non_manifold_points;
    notes->non_manifold_edges += w.notes.non_manifold_edges;
    notes->contrary_edges += w.notes.contrary_edges;
    *mesh = out;
    return HATCH_OK;
}
