#include "line/mesh.h"

#include "math/vector.h"
#include "line/edges.h"

/* Makes the mesh with one vertex per point, the first one of the point in the file, and subtracts the origin. */
static enum hatch_status weld(const struct hatch_mesh *from, const struct hatch_line_edges *edges,
                              const double origin[3], struct hatch_arena *arena, struct hatch_mesh *mesh,
                              struct hatch_err *err)
{
    struct hatch_mesh made;
    HATCH_TRY(hatch_mesh_make(arena, edges->point_count, from->face_count, &made, err));
    for (size_t i = 3 * (size_t)from->face_count; i-- > 0;) {
        const float *position = &from->attributes[0].data[3 * (size_t)from->indices[i]];
        made.indices[i] = edges->point[i];
        for (size_t k = 0; k < 3; k++)
            made.attributes[0].data[3 * (size_t)edges->point[i] + k] = (float)((double)position[k] - origin[k]);
    }
    *mesh = made;
    return HATCH_OK;
}

static uint32_t face_count(const struct hatch_line_edges *edges, uint32_t edge)
{
    return edges->edges.first[edge + 1] - edges->edges.first[edge];
}

/* Returns whether a silhouette may run along an edge. It may along a crack, whose faces stand alone at their edges. */
static bool may_turn(const struct hatch_line_edges *edges, uint32_t edge)
{
    return edges->kinds[edge] != HATCH_EDGE_BOUNDARY || face_count(edges, edge) > 1;
}

/* Returns whether an edge is drawn in every view. */
static bool is_feature(const struct hatch_line_edges *edges, uint32_t edge, uint32_t kinds)
{
    uint32_t kind = edges->kinds[edge] == HATCH_EDGE_CREASE     ? HATCH_LINES_CREASES
                    : edges->kinds[edge] == HATCH_EDGE_BOUNDARY ? HATCH_LINES_BOUNDARIES
                                                                : HATCH_LINES_NONE;
    return (kind & kinds) != 0;
}

/* Copies the edges where a silhouette may run. */
static enum hatch_status list_turns(const struct hatch_line_edges *from, struct hatch_arena *arena,
                                    struct hatch_line_turns *turns, struct hatch_err *err)
{
    struct hatch_line_turns made = {.count = 0};
    uint32_t sides = 0;
    HATCH_TRY(HATCH_ALLOC(arena, &made.first, (size_t)from->edges.count + 1, err));
    HATCH_TRY(HATCH_ALLOC(arena, &made.sides, from->edges.first[from->edges.count], err));
    HATCH_TRY(HATCH_ALLOC(arena, &made.creases, from->edges.count, err));
    for (uint32_t e = 0; e < from->edges.count; e++) {
        if (!may_turn(from, e))
            continue;
        for (uint32_t i = from->edges.first[e]; i < from->edges.first[e + 1]; i++)
            made.sides[sides++] = from->edges.sides[i];
        made.creases[made.count] = from->kinds[e] == HATCH_EDGE_CREASE;
        made.first[++made.count] = sides;
    }
    *turns = made;
    return HATCH_OK;
}

static enum hatch_status list_features(const struct hatch_line_edges *edges, uint32_t kinds, struct hatch_arena *arena,
                                       struct hatch_line_mesh *lines, struct hatch_err *err)
{
    size_t count = 0;
    for (uint32_t e = 0; e < edges->edges.count; e++)
        count += is_feature(edges, e, kinds);
    HATCH_TRY(HATCH_ALLOC(arena, &lines->features, count, err));
    for (uint32_t e = 0; e < edges->edges.count; e++) {
        if (!is_feature(edges, e, kinds))
            continue;
        const uint32_t *sides = &edges->edges.sides[edges->edges.first[e]];
        uint32_t corners[2], faces = face_count(edges, e);
        hatch_line_side_corners(edges->point, sides[0], corners);
        lines->features[lines->feature_count++] =
            (struct hatch_line_feature){.ends = {edges->point[corners[0]], edges->point[corners[1]]},
                                        .faces = {sides[0] / 3, faces > 1 ? sides[1] / 3 : HATCH_NONE},
                                        .more_faces = faces > 2};
    }
    return HATCH_OK;
}

/* Joins the features into chains; the nodes are the vertices at their ends. */
static enum hatch_status chain_features(struct hatch_arena *arena, struct hatch_arena *scratch,
                                        struct hatch_line_mesh *lines, struct hatch_err *err)
{
    size_t ends_count = 2 * (size_t)lines->feature_count;
    uint32_t *node_of, *ends;
    double *nodes;
    HATCH_TRY(HATCH_ALLOC(scratch, &node_of, lines->mesh.vertex_count, err)); /* per vertex: node + 1; 0: none */
    HATCH_TRY(HATCH_ALLOC(scratch, &ends, ends_count, err));
    HATCH_TRY(HATCH_ALLOC(scratch, &nodes, 3 * ends_count, err));
    HATCH_TRY(HATCH_ALLOC(arena, &lines->node_vertices, ends_count, err));
    for (size_t i = 0; i < ends_count; i++) {
        uint32_t vertex = lines->features[i / 2].ends[i % 2], *node = &node_of[vertex];
        if (*node == 0) {
            hatch_vec_of(&lines->mesh.attributes[0].data[3 * (size_t)vertex], &nodes[3 * (size_t)lines->node_count]);
            lines->node_vertices[lines->node_count++] = vertex;
            *node = lines->node_count;
        }
        ends[i] = *node - 1;
    }
    const struct hatch_line_graph graph = {lines->node_count, lines->feature_count, nodes, ends};
    return hatch_line_chains_make(&graph, arena, scratch, &lines->chains, err);
}

static enum hatch_status make(const struct hatch_mesh *from, const struct hatch_line_edges *found,
                              const double origin[3], const struct hatch_line_choice *choice, struct hatch_arena *arena,
                              struct hatch_arena *scratch, struct hatch_line_mesh *lines, struct hatch_err *err)
{
    struct hatch_line_edges edges;
    if (found)
        edges = *found;
    else
        HATCH_TRY(hatch_line_edges_find(from, false, scratch, arena, &edges, err));
    HATCH_TRY(hatch_line_edges_judge(from, choice->crease_rad, choice->normals_authored, scratch, arena, &edges, err));
    HATCH_TRY(weld(from, &edges, origin, arena, &lines->mesh, err));
    HATCH_TRY(list_turns(&edges, arena, &lines->turns, err));
    HATCH_TRY(list_features(&edges, choice->kinds, arena, lines, err));
    return chain_features(arena, scratch, lines, err);
}

enum hatch_status hatch_line_mesh_make(const struct hatch_mesh *from, const struct hatch_line_edges *edges,
                                       const double origin[3], const struct hatch_line_choice *choice,
                                       struct hatch_arena *arena, struct hatch_arena *scratch,
                                       struct hatch_line_mesh *lines, struct hatch_err *err)
{
    struct hatch_arena_mark mark = hatch_arena_mark(scratch);
    struct hatch_line_mesh made = {.feature_count = 0};
    enum hatch_status status = make(from, edges, origin, choice, arena, scratch, &made, err);
    hatch_arena_rewind(scratch, mark);
    if (status == HATCH_OK)
        *lines = made;
    return status;
}
