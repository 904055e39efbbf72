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

/* Finds the faces that are parts of planes: those with a neighbour across an edge of two faces that lies in their own
 * plane, within 0.26 degrees. Surfaces that bend everywhere, and noise, have hardly any.
 *   in_plane  out: per face: 1: part of a plane; 0: not */
void hatch_edges_find_planes(const struct hatch_mesh *mesh, const struct hatch_edges *edges, uint8_t *in_plane);

#endif
