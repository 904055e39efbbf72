#include "math/vector.h"
#include "mesh/dropped.h"
#include "mesh/fans.h"
#include "mesh/orient.h"
#include "mesh/skin/motion.h"
#include "surface/work.h"

static enum hatch_status find_faces(struct hatch_surface_work *w, struct hatch_surface_notes *notes,
                                    struct hatch_err *err)
{
    const struct hatch_mesh *mesh = w->mesh;
    uint32_t *vertex_to_point;
    HATCH_TRY(HATCH_ALLOC(w->scratch, &vertex_to_point, mesh->vertex_count, err));
    HATCH_TRY(HATCH_ALLOC(w->scratch, &w->point, (size_t)mesh->face_count * 3, err));
    HATCH_TRY(HATCH_ALLOC(w->scratch, &w->dropped, mesh->face_count, err));
    HATCH_TRY(hatch_mesh_weld_moving(mesh, w->scratch, vertex_to_point, &w->position_count, err));
    hatch_mesh_corner_points(mesh, vertex_to_point, w->point);
    notes->degenerate = hatch_mesh_find_degenerate(mesh, w->point, w->dropped);
    struct hatch_mesh_duplicates duplicates;
    HATCH_TRY(hatch_mesh_find_duplicates(w->point, mesh->face_count, w->dropped, w->scratch, &duplicates, err));
    notes->duplicate = duplicates.count;
    notes->reversed = duplicates.reversed;
    if (notes->degenerate + notes->duplicate == mesh->face_count)
        return hatch_fail(err, HATCH_BAD_INPUT, "no face has an area");
    return HATCH_OK;
}

/* Counts the vertices that no face uses, and those welded among the others. */
static enum hatch_status count_vertices(struct hatch_surface_work *w, struct hatch_surface_notes *notes,
                                        struct hatch_err *err)
{
    const struct hatch_mesh *mesh = w->mesh;
    uint8_t *vertex_used, *point_used;
    HATCH_TRY(HATCH_ALLOC(w->scratch, &vertex_used, mesh->vertex_count, err));
    HATCH_TRY(HATCH_ALLOC(w->scratch, &point_used, w->position_count, err));
    uint32_t vertices = 0, points = 0;
    for (uint32_t i = 0; i < mesh->face_count * 3; i++) {
        if (w->dropped[i / 3])
            continue;
        vertices += !vertex_used[mesh->indices[i]];
        points += !point_used[w->point[i]];
        vertex_used[mesh->indices[i]] = point_used[w->point[i]] = 1;
    }
    notes->unreferenced = mesh->vertex_count - vertices;
    notes->welded = vertices - points;
    return HATCH_OK;
}

static enum hatch_status orient(struct hatch_surface_work *w, struct hatch_surface_notes *notes, struct hatch_err *err)
{
    const struct hatch_connectivity faces = {w->point, w->mesh->face_count, w->position_count, w->dropped};
    struct hatch_orientation oriented = {.flipped = w->flipped, .component = w->component};
    HATCH_TRY(hatch_mesh_orient(w->mesh, &faces, w->partner, w->scratch, &oriented, err));
    w->component_count = oriented.components;
    notes->components = oriented.components;
    notes->flipped = oriented.faces_flipped;
    notes->contrary = oriented.contrary_edges;
    return HATCH_OK;
}

/* Faces at an edge with more than two faces can be paired only once they are oriented. Components that are joined by
 * such pairs are then oriented again, as one. */
static enum hatch_status join_faces(struct hatch_surface_work *w, struct hatch_surface_notes *notes,
                                    struct hatch_err *err)
{
    hatch_edges_partners(&w->edges, NULL, w->mesh->face_count, w->partner);
    HATCH_TRY(orient(w, notes, err));
    for (uint32_t e = 0; e < w->edges.count; e++)
        notes->edges_cut += w->edges.first[e + 1] - w->edges.first[e] > 2;
    if (notes->edges_cut && hatch_surface_stitch_edges(w))
        return orient(w, notes, err);
    return HATCH_OK;
}

static enum hatch_status connect_faces(struct hatch_surface_work *w, struct hatch_surface_notes *notes,
                                       struct hatch_err *err)
{
    const struct hatch_connectivity faces = {w->point, w->mesh->face_count, w->position_count, w->dropped};
    size_t corners = (size_t)faces.face_count * 3;
    HATCH_TRY(HATCH_ALLOC(w->scratch, &w->flipped, faces.face_count, err));
    HATCH_TRY(HATCH_ALLOC(w->scratch, &w->component, faces.face_count, err));
    HATCH_TRY(HATCH_ALLOC(w->scratch, &w->fan, corners, err));
    HATCH_TRY(HATCH_ALLOC(w->scratch, &w->partner, corners, err));
    HATCH_TRY(hatch_edges_find(&faces, w->scratch, w->scratch, &w->edges, err));
    HATCH_TRY(join_faces(w, notes, err));
    if (w->planes)
        HATCH_TRY(hatch_surface_find_planes(w, err));
    w->fan_count = hatch_mesh_corner_fans(w->point, w->partner, NULL, faces.face_count, w->fan);
    return hatch_mesh_count_pinched(&faces, &w->edges, w->scratch, &notes->points_split, err);
}

static enum hatch_status make(struct hatch_surface_work *w, struct hatch_surface *surface,
                              struct hatch_surface_notes *notes, struct hatch_err *err)
{
    HATCH_TRY(hatch_mesh_check(w->mesh, err));
    HATCH_TRY(find_faces(w, notes, err));
    HATCH_TRY(count_vertices(w, notes, err));
    HATCH_TRY(connect_faces(w, notes, err));
    HATCH_TRY(hatch_surface_build_components(w, surface, err));
    hatch_surface_normalize(surface);
    HATCH_TRY(hatch_surface_find_topology(surface, w->scratch, err));
    return hatch_surface_make_rings(surface, w->arena, w->scratch, err);
}

static enum hatch_status make_surface(struct hatch_surface_work *work, struct hatch_surface *surface,
                                      struct hatch_surface_notes *notes, struct hatch_err *err)
{
    struct hatch_arena_mark mark = hatch_arena_mark(work->scratch);
    struct hatch_surface made = {0};
    struct hatch_surface_notes changes = {0};
    enum hatch_status status = make(work, &made, &changes, err);
    hatch_arena_rewind(work->scratch, mark);
    HATCH_TRY(status);
    *surface = made;
    *notes = changes;
    return HATCH_OK;
}

enum hatch_status hatch_surface_make(const struct hatch_mesh *mesh, struct hatch_arena *arena,
                                     struct hatch_arena *scratch, struct hatch_surface *surface,
                                     struct hatch_surface_notes *notes, struct hatch_err *err)
{
    struct hatch_surface_work work = {.mesh = mesh, .arena = arena, .scratch = scratch};
    return make_surface(&work, surface, notes, err);
}

enum hatch_status hatch_surface_make_cut(const struct hatch_mesh *mesh, struct hatch_arena *arena,
                                         struct hatch_arena *scratch, struct hatch_surface *surface,
                                         struct hatch_surface_notes *notes, struct hatch_err *err)
{
    struct hatch_surface_work work = {.mesh = mesh, .arena = arena, .scratch = scratch, .planes = true};
    return make_surface(&work, surface, notes, err);
}

void hatch_surface_face_normal(const struct hatch_surface *surface, uint32_t face, double normal[3])
{
    const uint32_t *corner = &surface->corners[(size_t)face * 3];
    hatch_vec_triangle(&surface->points[(size_t)corner[0] * 3], &surface->points[(size_t)corner[1] * 3],
                       &surface->points[(size_t)corner[2] * 3], normal);
}

void hatch_surface_position(const struct hatch_surface *surface, uint32_t point, double position[3])
{
    const struct hatch_component *component = &surface->components[surface->point_component[point]];
    for (uint32_t k = 0; k < 3; k++)
        position[k] = component->center[k] + component->scale * surface->points[(size_t)point * 3 + k];
}
