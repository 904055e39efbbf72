/* Which edges of a mesh an illustrator draws. */
#ifndef HATCH_MESH_CREASES_H
#define HATCH_MESH_CREASES_H

#include "mesh/edges.h"

enum hatch_edge_kind { HATCH_EDGE_SMOOTH, HATCH_EDGE_CREASE, HATCH_EDGE_BOUNDARY };

/* Finds the kind of every edge from the directions in which its faces leave it, so that neither the
 * faces' winding nor how often a face is given matters. Boundary: all faces leave it in one direction.
 * Smooth: all leave it in two directions that are opposite but for at most crease_rad. Crease: any
 * other. A face without area has no direction and says nothing.
 * edges: of the mesh's faces. crease_rad: 0 .. π. kinds: edges->count entries, enum hatch_edge_kind. */
void hatch_edges_kinds(const struct hatch_mesh *mesh, const struct hatch_edges *edges, double crease_rad,
                       uint8_t *kinds);

/* Adds NORMAL to a mesh without: as hatch_mesh_add_normals does, but split where the caller says.
 * point: of the corners; edges: found with them. sharp: per edge, not 0: normals jump there; edges of
 * one face or of more than two split them always. Corners keep their order. */
enum hatch_status hatch_mesh_split_normals(const uint32_t *point, const struct hatch_edges *edges, const uint8_t *sharp,
                                           struct hatch_arena *arena, struct hatch_arena *scratch,
                                           struct hatch_mesh *mesh, struct hatch_err *err) HATCH_MUST_USE;

#endif
