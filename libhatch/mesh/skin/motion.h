/* How skins and morph targets move vertices. */
#ifndef HATCH_MESH_SKIN_MOTION_H
#define HATCH_MESH_SKIN_MOTION_H

#include "mesh/remap.h"

/* Returns whether a mesh has what moves its vertices: joints, or morph targets. */
bool hatch_mesh_moves(const struct hatch_mesh *mesh);

/* Computes by how much each vertex moves in a pose that is made up: vertices at one position stay together in all poses
 * if they move by the same amount in this one, and come apart in some pose if not. Different orders of the same joints
 * are the same but for rounding.
 *   motion  out: 3 per vertex */
void hatch_mesh_motion(const struct hatch_mesh *mesh, float *motion);

/* Numbers the different positions like hatch_mesh_weld, but vertices at one position that come apart in some pose have
 * different numbers. */
enum hatch_status hatch_mesh_weld_moving(const struct hatch_mesh *mesh, struct hatch_arena *scratch,
                                         uint32_t *vertex_to_point, uint32_t *point_count,
                                         struct hatch_err *err) HATCH_MUST_USE;

/* Makes a table of vertices that stay together in all poses and are equal in NORMAL, which the mesh must have.
 *   remap  out: its arrays are in arena */
enum hatch_status hatch_mesh_remap_by_normal(const struct hatch_mesh *mesh, struct hatch_arena *arena,
                                             struct hatch_arena *scratch, struct hatch_remap *remap,
                                             struct hatch_err *err) HATCH_MUST_USE;

#endif
