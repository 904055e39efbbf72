/* The edges of a mesh that may become feature lines: vertices at one position that stay together in all poses are
 * welded, edges are classified at a pose, and creases due to noise count as smooth. */
#ifndef HATCH_LINE_EDGES_H
#define HATCH_LINE_EDGES_H

#include "mesh/edge_kinds.h"
#include "line/chain.h"

struct hatch_line_edges {
    uint32_t *point; /* per face corner: number of its welded point */
    uint32_t point_count;
    struct hatch_edges edges; /* between points */
    uint8_t *kinds;           /* per edge, enum hatch_edge_kind; NULL: not judged yet */
};

/* Welds a mesh and finds its edges.
 *   deformed  skins or morph targets move the mesh: only vertices that these move alike are welded
 *   arena     for the edges; not the scratch arena */
enum hatch_status hatch_line_edges_find(const struct hatch_mesh *mesh, bool deformed, struct hatch_arena *arena,
                                        struct hatch_arena *scratch, struct hatch_line_edges *edges,
                                        struct hatch_err *err) HATCH_MUST_USE;

/* Classifies the edges. Creases due to noise, cracks and boundaries within faces (line/prune.h) count as smooth edges.
 *   mesh              as for hatch_line_edges_find, at any pose; POSITION and NORMAL count
 *   crease_rad        least angle between the faces at a crease, 0 .. π
 *   normals_authored  the mesh's normals are from its file, not computed from its faces. If they are continuous at an
 *                     edge, it is a crease only beyond 60 degrees, which is more than tessellated curves turn
 *   arena             for the kinds; not the scratch arena */
enum hatch_status hatch_line_edges_judge(const struct hatch_mesh *mesh, double crease_rad, bool normals_authored,
                                         struct hatch_arena *arena, struct hatch_arena *scratch,
                                         struct hatch_line_edges *edges, struct hatch_err *err) HATCH_MUST_USE;

/* Returns the face corners at both ends of a side, first the one whose point has the lower number.
 *   point  as in struct hatch_line_edges */
void hatch_line_side_corners(const uint32_t *point, uint32_t side, uint32_t corners[2]);

#endif
