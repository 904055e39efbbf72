#include "line/mesh.h"

#include <string.h>

#include "math/vector.h"
#include "line/edges.h"
#include "mesh/remap.h"

/* Returns whether the mesh's normals are continuous across a crease. */
static bool smooths_creases(const struct hatch_mesh *mesh, const struct hatch_line_edges *edges)
{
    for (uint32_t e = 0; e < edges->edges.count; e++)
        if (edges->kinds[e] == HATCH_EDGE_CREASE && hatch_line_edge_is_smoothed(mesh, edges, e))
            return true;
    return false;
}

/* Copies the attributes that lines need, with normals that are discontinuous at creases. */
static enum hatch_status select_attributes(const struct hatch_mesh *from, const struct hatch_line_edges *edges,
                                           struct hatch_arena *arena, struct hatch_arena *scratch,
                                           struct hatch_mesh *mesh, struct hatch_err *err)
{
    static const char *const used[] = {"POSITION",           "NORMAL",          "JOINTS_0", "WEIGHTS_0",
                                       HATCH_MORPH_POSITION, HATCH_MORPH_NORMAL};
    bool keep = hatch_mesh_find(from, "NORMAL", 3) && !smooths_creases(from, edges);
    struct hatch_mesh made = *from;
    made.attribute_count = 0;
    for (uint32_t i = 0; i < from->attribute_count; i++)
        for (size_t k = 0; k < sizeof used / sizeof *used; k++)
            if (strcmp(from->attributes[i].name, used[k]) == 0 && (k != 1 || keep))
                made.attributes[made.attribute_count++] = from->attributes[i];
    if (!keep) {
        uint8_t *sharp;
        HATCH_TRY(HATCH_ALLOC(arena, &sharp, edges->edges.count, err));
        for (uint32_t e = 0; e < edges->edges.count; e++)
            sharp[e] = edges->kinds[e] == HATCH_EDGE_CREASE;
        HATCH_TRY(hatch_mesh_split_normals(edges->point, &edges->edges, sharp, arena, scratch, &made, err));
    }
    *mesh = made;
    return HATCH_OK;
}

/* Joins vertices that are equal in position and normal, and subtracts the origin. */
static enum hatch_status join_vertices(const struct hatch_mesh *selected, const double origin[3],
                                       struct hatch_arena *arena, struct hatch_arena *scratch, struct hatch_mesh *mesh,
                                       struct hatch_err *err)
{
    struct hatch_remap weld;
    struct hatch_mesh made;
    HATCH_TRY(hatch_remap_by_normal(selected, scratch, arena, &weld, err));
    HATCH_TRY(hatch_mesh_make(arena, weld.count, selected->face_count, &made, err));
    for (size_t i = 0; i < 3 * (size_t)made.face_count; i++)
        made.indices[i] = weld.number[selected->indices[i]];
    HATCH_TRY(hatch_remap_attributes(selected, weld.first, arena, &made, err));
    float *position = made.attributes[0].data;
    for (size_t i = 0; i < 3 * (size_t)made.vertex_count; i++)
        position[i] = (float)((double)position[i] - origin[i % 3]);
    *mesh = made;
    return HATCH_OK;
}

/* How an edge is used. */
struct edge_use {
    uint32_t a[2], b[2]; /* face corners at its ends: of its first face, of its second */
    bool smooth;         /* normals are continuous: a silhouette crosses it without a gap */
    bool hard;           /* a silhouette may run along it */
    bool feature;        /* it is drawn in every view */
};

static struct edge_use use_of(const struct hatch_line_edges *edges, const struct hatch_mesh *mesh, uint32_t edge,
                              uint32_t kinds)
{
    const uint32_t *sides = &edges->edges.sides[edges->edges.first[edge]];
    const uint32_t *indices = mesh->indices;
    uint32_t count = edges->edges.first[edge + 1] - edges->edges.first[edge];
    uint32_t kind = edges->kinds[edge] == HATCH_EDGE_CREASE     ? HATCH_LINES_CREASES
                    : edges->kinds[edge] == HATCH_EDGE_BOUNDARY ? HATCH_LINES_BOUNDARIES
                                                                : HATCH_LINES_NONE;
    struct edge_use use = {.feature = kind & kinds};
    hatch_line_side_corners(edges->point, sides[0], use.a);
    hatch_line_side_corners(edges->point, sides[count > 1 ? 1 : 0], use.b);
    use.smooth = count == 2 && indices[use.a[0]] == indices[use.b[0]] && indices[use.a[1]] == indices[use.b[1]];
    /* An edge of more than two faces is never hard, because it is ambiguous which of them form its two sides. If its
     * kind is smooth, sheets coincide there, and the silhouette of each sheet crosses it. */
    use.hard = count == 2 && !use.smooth;
    return use;
}

/* Adds an edge to the hard edges and to the features, if it is one.
 *   points  out: 2 per feature: the points at its ends */
static void add_edge(const struct hatch_line_edges *edges, uint32_t edge, uint32_t kinds, uint32_t *points,
                     struct hatch_line_mesh *lines)
{
    const uint32_t *sides = &edges->edges.sides[edges->edges.first[edge]];
    const uint32_t *indices = lines->mesh.indices, *point = edges->point;
    uint32_t count = edges->edges.first[edge + 1] - edges->edges.first[edge];
    struct edge_use use = use_of(edges, &lines->mesh, edge, kinds);
    const uint32_t *a = use.a, *b = use.b;
    for (uint32_t i = 0; i < count && !use.smooth; i++)
        lines->hard_sides[sides[i] / 3] |= (uint8_t)(1u << sides[i] % 3);
    if (use.hard)
        lines->hard_edges[lines->hard_edge_count++] =
            (struct hatch_line_hard_edge){.low = {indices[a[0]], indices[b[0]]},
                                          .high = {indices[a[1]], indices[b[1]]},
                                          .points = {point[a[0]], point[a[1]]}};
    if (!use.feature)
        return;
    points[2 * lines->feature_count] = point[a[0]];
    points[2 * lines->feature_count + 1] = point[a[1]];
    lines->features[lines->feature_count++] =
        (struct hatch_line_feature){.ends = {indices[a[0]], indices[a[1]]},
                                    .faces = {sides[0] / 3, count > 1 ? sides[1] / 3 : HATCH_NONE},
                                    .more_faces = count > 2};
}

static enum hatch_status sort_edges(const struct hatch_line_edges *edges, uint32_t kinds, struct hatch_arena *arena,
                                    struct hatch_arena *scratch, struct hatch_line_mesh *lines, uint32_t **points,
                                    struct hatch_err *err)
{
    size_t hard_edges = 0, features = 0;
    for (uint32_t e = 0; e < edges->edges.count; e++) {
        struct edge_use use = use_of(edges, &lines->mesh, e, kinds);
        hard_edges += use.hard;
        features += use.feature;
    }
    HATCH_TRY(HATCH_ALLOC(scratch, points, 2 * features, err));
    HATCH_TRY(HATCH_ALLOC(arena, &lines->hard_sides, lines->mesh.face_count, err));
    HATCH_TRY(HATCH_ALLOC(arena, &lines->hard_edges, hard_edges, err));
    HATCH_TRY(HATCH_ALLOC(arena, &lines->features, features, err));
    for (uint32_t e = 0; e < edges->edges.count; e++)
        add_edge(edges, e, kinds, *points, lines);
    return HATCH_OK;
}

/* Joins the features into chains; the nodes are the points at their ends. */
static enum hatch_status chain_features(const struct hatch_line_edges *edges, const uint32_t *points,
                                        struct hatch_arena *arena, struct hatch_arena *scratch,
                                        struct hatch_line_mesh *lines, struct hatch_err *err)
{
    size_t ends_count = 2 * (size_t)lines->feature_count;
    uint32_t *node_of, *ends;
    double *nodes;
    HATCH_TRY(HATCH_ALLOC(scratch, &node_of, edges->point_count, err)); /* per point: node + 1; 0: none */
    HATCH_TRY(HATCH_ALLOC(scratch, &ends, ends_count, err));
    HATCH_TRY(HATCH_ALLOC(scratch, &nodes, 3 * ends_count, err));
    HATCH_TRY(HATCH_ALLOC(arena, &lines->node_vertices, ends_count, err));
    for (size_t i = 0; i < ends_count; i++) {
        uint32_t vertex = lines->features[i / 2].ends[i % 2], *node = &node_of[points[i]];
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

static enum hatch_status make(const struct hatch_mesh *from, const double origin[3],
                              const struct hatch_line_choice *choice, struct hatch_arena *arena,
                              struct hatch_arena *scratch, struct hatch_line_mesh *lines, struct hatch_err *err)
{
    struct hatch_mesh selected;
    struct hatch_line_edges edges;
    HATCH_TRY(hatch_line_edges_find(from, choice->crease_rad, choice->normals_authored, scratch, arena, &edges, err));
    HATCH_TRY(select_attributes(from, &edges, scratch, arena, &selected, err));
    HATCH_TRY(join_vertices(&selected, origin, arena, scratch, &lines->mesh, err));
    HATCH_TRY(hatch_line_ring_make(&lines->mesh, arena, scratch, &lines->ring, err));
    uint32_t *points;
    HATCH_TRY(sort_edges(&edges, choice->kinds, arena, scratch, lines, &points, err));
    return chain_features(&edges, points, arena, scratch, lines, err);
}

enum hatch_status hatch_line_mesh_make(const struct hatch_mesh *from, const double origin[3],
                                       const struct hatch_line_choice *choice, struct hatch_arena *arena,
                                       struct hatch_arena *scratch, struct hatch_line_mesh *lines,
                                       struct hatch_err *err)
{
    struct hatch_arena_mark mark = hatch_arena_mark(scratch);
    struct hatch_line_mesh made = {.hard_edge_count = 0};
    enum hatch_status status = make(from, origin, choice, arena, scratch, &made, err);
    hatch_arena_rewind(scratch, mark);
    if (status == HATCH_OK)
        *lines = made;
    return status;
}
