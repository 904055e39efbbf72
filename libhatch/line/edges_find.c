#include <math.h>

#include "math/vector.h"
#include "mesh/fans.h"
#include "mesh/remap.h"
#include "mesh/skin/motion.h"
#include "line/prune.h"

#define WELD 4e-5 /* tolerance of loose welding, in diagonals of the mesh: 1/20 of a pixel in a picture of it */
#define COS_SAME_NORMAL 0.9999                 /* cosine of the largest angle between normals that count as equal */
#define SMOOTHED_CREASE_RAD 1.0471975511965976 /* 60 degrees: sharper edges stay creases whatever the normals */

/* Rounds the positions or the motion of the vertices of loose points to a grid; others are copied.
 *   from   3 per vertex
 *   point  per vertex: its point
 *   loose  per point: not 0: it is loose
 *   shift  of the grid, in steps */
static void snap(const float *from, uint32_t vertex_count, const uint32_t *point, const uint8_t *loose, double step,
                 double shift, float *snapped)
{
    for (size_t i = 0; i < 3 * (size_t)vertex_count; i++)
        snapped[i] = loose[point[i / 3]] && step > 0 ? (float)(floor((double)from[i] / step + shift) * step) : from[i];
}

/* Joins loose points at a distance of up to about WELD, and renumbers all points. Points are joined if they fall into
 * one cell of either of two grids, one of which is shifted by half a cell; so do the amounts by which they move.
 *   motion     3 per vertex, from hatch_mesh_motion: vertices that move differently stay apart; NULL: none move
 *   of_vertex  in and out: point of each vertex */
static enum hatch_status weld(const struct hatch_mesh *mesh, const float *motion, const uint8_t *loose,
                              struct hatch_arena *scratch, uint32_t *of_vertex, uint32_t *count, struct hatch_err *err)
{
    struct hatch_mesh moved = *mesh;
    size_t vertices = mesh->vertex_count;
    uint32_t *cell, *first, cells;
    float *amounts = NULL;
    const double step = WELD * hatch_mesh_diagonal(mesh);
    HATCH_TRY(HATCH_ALLOC(scratch, &moved.attributes[0].data, 3 * vertices, err));
    if (motion)
        HATCH_TRY(HATCH_ALLOC(scratch, &amounts, 3 * vertices, err));
    HATCH_TRY(HATCH_ALLOC(scratch, &cell, vertices, err));
    HATCH_TRY(HATCH_ALLOC(scratch, &first, vertices, err));
    uint32_t *parent;
    HATCH_TRY(HATCH_ALLOC(scratch, &parent, vertices, err));
    hatch_sets_init(parent, mesh->vertex_count);
    for (int grid = 0; grid < 2; grid++) {
        snap(mesh->attributes[0].data, mesh->vertex_count, of_vertex, loose, step, 0.5 * grid,
             moved.attributes[0].data);
        if (motion)
            snap(motion, mesh->vertex_count, of_vertex, loose, step, 0.5 * grid, amounts);
        HATCH_TRY(motion ? hatch_remap_weld(&moved, amounts, scratch, cell, &cells, err)
                         : hatch_mesh_weld(&moved, scratch, cell, &cells, err));
        for (uint32_t v = mesh->vertex_count; v-- > 0;)
            first[cell[v]] = v;
        for (uint32_t v = 0; v < mesh->vertex_count; v++)
            hatch_sets_join(parent, first[cell[v]], v);
    }
    *count = 0;
    for (uint32_t v = 0; v < mesh->vertex_count; v++)
        cell[v] = hatch_sets_find(parent, v);
    for (uint32_t v = 0; v < mesh->vertex_count; v++)
        of_vertex[v] = cell[v] == v ? (*count)++ : of_vertex[cell[v]];
    return HATCH_OK;
}

/* Finds the edges between points.
 *   of_vertex  point of each vertex */
static enum hatch_status find_edges(const struct hatch_mesh *mesh, const uint32_t *of_vertex, struct hatch_arena *arena,
                                    struct hatch_arena *scratch, struct hatch_line_edges *made, struct hatch_err *err)
{
    uint8_t *dropped;
    HATCH_TRY(HATCH_ALLOC(scratch, &dropped, mesh->face_count, err));
    HATCH_TRY(HATCH_ALLOC(arena, &made->point, 3 * (size_t)mesh->face_count, err));
    hatch_mesh_corner_points(mesh, of_vertex, made->point);
    for (size_t f = 0; f < mesh->face_count; f++) {
        const uint32_t *p = &made->point[3 * f];
        dropped[f] = p[0] == p[1] || p[1] == p[2] || p[2] == p[0];
    }
    const struct hatch_connectivity faces = {made->point, mesh->face_count, made->point_count, dropped};
    return hatch_edges_find(&faces, arena, scratch, &made->edges, err);
}

/* Marks the points at the ends of boundary edges as loose. Returns whether there are any. */
static bool mark_loose(const struct hatch_line_edges *made, uint8_t *loose)
{
    bool any = false;
    for (uint32_t e = 0; e < made->edges.count; e++) {
        uint32_t side = made->edges.sides[made->edges.first[e]];
        if (made->edges.first[e + 1] - made->edges.first[e] > 1)
            continue;
        loose[made->point[side]] = loose[made->point[hatch_side_end(side)]] = 1;
        any = true;
    }
    return any;
}

/* Many programs write parts of a surface separately, with different rounding along their borders, so points at
 * boundaries are welded a second time, with a tolerance. */
static enum hatch_status find(const struct hatch_mesh *mesh, bool deformed, struct hatch_arena *arena,
                              struct hatch_arena *scratch, struct hatch_line_edges *made, struct hatch_err *err)
{
    uint32_t *of_vertex;
    uint8_t *loose;
    float *motion = NULL;
    if (deformed) {
        HATCH_TRY(HATCH_ALLOC(scratch, &motion, 3 * (size_t)mesh->vertex_count, err));
        hatch_mesh_motion(mesh, motion);
    }
    HATCH_TRY(HATCH_ALLOC(scratch, &of_vertex, mesh->vertex_count, err));
    HATCH_TRY(HATCH_ALLOC(scratch, &loose, mesh->vertex_count, err));
    struct hatch_arena_mark mark = hatch_arena_mark(arena);
    HATCH_TRY(motion ? hatch_remap_weld(mesh, motion, scratch, of_vertex, &made->point_count, err)
                     : hatch_mesh_weld(mesh, scratch, of_vertex, &made->point_count, err));
    HATCH_TRY(find_edges(mesh, of_vertex, arena, scratch, made, err));
    if (mark_loose(made, loose)) {
        hatch_arena_rewind(arena, mark);
        HATCH_TRY(weld(mesh, motion, loose, scratch, of_vertex, &made->point_count, err));
        HATCH_TRY(find_edges(mesh, of_vertex, arena, scratch, made, err));
    }
    return HATCH_OK;
}

enum hatch_status hatch_line_edges_find(const struct hatch_mesh *mesh, bool deformed, struct hatch_arena *arena,
                                        struct hatch_arena *scratch, struct hatch_line_edges *edges,
                                        struct hatch_err *err)
{
    struct hatch_arena_mark mark = hatch_arena_mark(scratch);
    struct hatch_line_edges made = {.kinds = NULL};
    enum hatch_status status = find(mesh, deformed, arena, scratch, &made, err);
    hatch_arena_rewind(scratch, mark);
    if (status == HATCH_OK)
        *edges = made;
    return status;
}

static bool same_normal(const struct hatch_mesh *mesh, uint32_t a, uint32_t b)
{
    const float *normals = hatch_mesh_find(mesh, "NORMAL", 3);
    double na[3], nb[3];
    hatch_vec_of(&normals[(size_t)mesh->indices[a] * 3], na);
    hatch_vec_of(&normals[(size_t)mesh->indices[b] * 3], nb);
    return hatch_vec_dot(na, nb) >= COS_SAME_NORMAL * hatch_vec_length(na) * hatch_vec_length(nb);
}

/* Returns whether both faces of an edge have the same normal at one of its ends or at both.
 *   mesh  has NORMAL
 *   edge  of two faces or more */
static bool is_smoothed(const struct hatch_mesh *mesh, const struct hatch_line_edges *edges, uint32_t edge)
{
    const uint32_t *sides = &edges->edges.sides[edges->edges.first[edge]];
    uint32_t a[2], b[2];
    hatch_line_side_corners(edges->point, sides[0], a);
    hatch_line_side_corners(edges->point, sides[1], b);
    return same_normal(mesh, a[0], b[0]) || same_normal(mesh, a[1], b[1]);
}

/* Makes creases smooth edges where authored normals are continuous, except at edges sharper than
 * SMOOTHED_CREASE_RAD. */
static enum hatch_status trust_normals(const struct hatch_mesh *mesh, struct hatch_arena *scratch,
                                       struct hatch_line_edges *edges, struct hatch_err *err)
{
    uint8_t *sharp;
    HATCH_TRY(HATCH_ALLOC(scratch, &sharp, edges->edges.count, err));
    hatch_edges_classify(mesh, &edges->edges, SMOOTHED_CREASE_RAD, sharp);
    for (uint32_t e = 0; e < edges->edges.count; e++)
        if (edges->kinds[e] == HATCH_EDGE_CREASE && sharp[e] == HATCH_EDGE_SMOOTH && is_smoothed(mesh, edges, e))
            edges->kinds[e] = HATCH_EDGE_SMOOTH;
    return HATCH_OK;
}

/* Makes a graph of all edges that are not smooth; its nodes are the points.
 *   edge_of  out: per segment of the graph: its edge */
static enum hatch_status make_graph(const struct hatch_mesh *mesh, const struct hatch_line_edges *edges,
                                    struct hatch_arena *arena, struct hatch_line_graph *graph, uint32_t **edge_of,
                                    struct hatch_err *err)
{
    uint32_t count = 0;
    for (uint32_t e = 0; e < edges->edges.count; e++)
        count += edges->kinds[e] != HATCH_EDGE_SMOOTH;
    double *nodes;
    uint32_t *ends;
    HATCH_TRY(HATCH_ALLOC(arena, &nodes, 3 * (size_t)edges->point_count, err));
    HATCH_TRY(HATCH_ALLOC(arena, &ends, 2 * (size_t)count, err));
    HATCH_TRY(HATCH_ALLOC(arena, edge_of, count, err));
    for (size_t i = 0; i < 3 * (size_t)mesh->face_count; i++)
        hatch_vec_of(&mesh->attributes[0].data[3 * (size_t)mesh->indices[i]], &nodes[3 * (size_t)edges->point[i]]);
    count = 0;
    for (uint32_t e = 0; e < edges->edges.count; e++) {
        if (edges->kinds[e] == HATCH_EDGE_SMOOTH)
            continue;
        uint32_t side = edges->edges.sides[edges->edges.first[e]];
        ends[2 * count] = edges->point[side];
        ends[2 * count + 1] = edges->point[hatch_side_end(side)];
        (*edge_of)[count++] = e;
    }
    *graph = (struct hatch_line_graph){edges->point_count, count, nodes, ends};
    return HATCH_OK;
}

/* Finds the edges between planes.
 *   edge_of  per segment of the graph: its edge
 *   flat     out: per segment: 1: all its faces are parts of planes */
static enum hatch_status find_flat(const struct hatch_mesh *mesh, const struct hatch_edges *edges,
                                   const uint32_t *edge_of, uint32_t segment_count, struct hatch_arena *scratch,
                                   uint8_t *flat, struct hatch_err *err)
{
    uint8_t *in_plane;
    HATCH_TRY(HATCH_ALLOC(scratch, &in_plane, mesh->face_count, err));
    hatch_edges_find_planes(mesh, edges, in_plane);
    for (uint32_t i = 0; i < segment_count; i++) {
        uint32_t s = edges->first[edge_of[i]], end = edges->first[edge_of[i] + 1];
        while (s < end && in_plane[edges->sides[s] / 3])
            s++;
        flat[i] = s == end;
    }
    return HATCH_OK;
}

static enum hatch_status judge(const struct hatch_mesh *mesh, double crease_rad, bool normals_authored,
                               struct hatch_arena *arena, struct hatch_arena *scratch, struct hatch_line_edges *made,
                               struct hatch_err *err)
{
    struct hatch_line_graph graph;
    uint32_t *edge_of;
    HATCH_TRY(HATCH_ALLOC(arena, &made->kinds, made->edges.count, err));
    hatch_edges_classify(mesh, &made->edges, crease_rad, made->kinds);
    if (normals_authored && hatch_mesh_find(mesh, "NORMAL", 3))
        HATCH_TRY(trust_normals(mesh, scratch, made, err));
    HATCH_TRY(hatch_line_drop_covered(mesh, arena, made, err));
    HATCH_TRY(make_graph(mesh, made, scratch, &graph, &edge_of, err));
    uint8_t *bounds, *flat, *pruned;
    HATCH_TRY(HATCH_ALLOC(scratch, &bounds, graph.segment_count, err));
    HATCH_TRY(HATCH_ALLOC(scratch, &flat, graph.segment_count, err));
    HATCH_TRY(HATCH_ALLOC(scratch, &pruned, graph.segment_count, err));
    HATCH_TRY(find_flat(mesh, &made->edges, edge_of, graph.segment_count, scratch, flat, err));
    for (uint32_t i = 0; i < graph.segment_count; i++)
        bounds[i] = made->kinds[edge_of[i]] == HATCH_EDGE_BOUNDARY;
    HATCH_TRY(hatch_line_find_cracks(&graph, bounds, arena, pruned, err));
    HATCH_TRY(hatch_line_prune(&graph, bounds, flat, hatch_mesh_diagonal(mesh), scratch, arena, pruned, err));
    for (uint32_t i = 0; i < graph.segment_count; i++)
        if (pruned[i])
            made->kinds[edge_of[i]] = HATCH_EDGE_SMOOTH;
    return HATCH_OK;
}

enum hatch_status hatch_line_edges_judge(const struct hatch_mesh *mesh, double crease_rad, bool normals_authored,
                                         struct hatch_arena *arena, struct hatch_arena *scratch,
                                         struct hatch_line_edges *edges, struct hatch_err *err)
{
    struct hatch_arena_mark mark = hatch_arena_mark(scratch);
    struct hatch_line_edges judged = *edges;
    enum hatch_status status = judge(mesh, crease_rad, normals_authored, arena, scratch, &judged, err);
    hatch_arena_rewind(scratch, mark);
    if (status == HATCH_OK)
        *edges = judged;
    return status;
}

void hatch_line_side_corners(const uint32_t *point, uint32_t side, uint32_t corners[2])
{
    uint32_t end = hatch_side_end(side);
    bool rising = point[side] < point[end];
    corners[0] = rising ? side : end;
    corners[1] = rising ? end : side;
}
