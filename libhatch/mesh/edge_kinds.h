/* Classification of edges: boundaries, creases and smooth edges. */
#ifndef HATCH_MESH_EDGE_KINDS_H
#define HATCH_MESH_EDGE_KINDS_H

#include "mesh/edges.h"

enum hatch_edge_kind { HATCH_EDGE_SMOOTH, HATCH_EDGE_CREASE, HATCH_EDGE_BOUNDARY };

/* Classifies every edge by the directions in which its faces extend from it, so that neither winding nor duplicate
 * faces matter. Boundary: all faces extend in one direction. Smooth: the faces extend in two directions, which are
 * opposite within crease_rad. Crease: any other edge. Faces without area are ignored; an edge of several faces of which
 * at most one has an area is smooth.
 *   edges       of the mesh's faces
 *   crease_rad  0 .. π
 *   kinds       out: per edge, enum hatch_edge_kind */
void hatch_edges_classify(const struct hatch_mesh *mesh, const struct hatch_edges *edges, double crease_rad,
                          uint8_t *kinds);

/* Adds NORMAL to a mesh without it, as hatch_mesh_add_normals does, but splits vertices at sharp edges and at edges
 * that do not have exactly two faces. Corners keep their order.
 *   point  3 * face_count: the point of each corner
 *   edges  the edges between these points
 *   sharp  per edge, not 0: normals differ across it */
enum hatch_status hatch_mesh_split_normals(const uint32_t *point, const struct hatch_edges *edges, const uint8_t *sharp,
                                           struct hatch_arena *arena, struct hatch_arena *scratch,
                                           struct hatch_mesh *mesh, struct hatch_err *err) HATCH_MUST_USE;

#endif
