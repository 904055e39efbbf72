/* Vertex remap tables: vertices that are equal in position and in one other attribute, or in other values, get the same
 * new index. */
#ifndef HATCH_MESH_REMAP_H
#define HATCH_MESH_REMAP_H

#include "mesh/mesh.h"

struct hatch_remap {
    uint32_t count;   /* number of different vertices */
    uint32_t *number; /* per vertex: its new index, below count, in order of appearance */
    uint32_t *first;  /* per new index: the first vertex that has it; with room for all vertices */
};

/* Makes a table of vertices that are one point and equal in three values each. -0 equals 0.
 *   point   per vertex; NULL: those with the same POSITION are one
 *   values  3 per vertex
 *   remap   out: its arrays are in arena, which may be the scratch arena */
enum hatch_status hatch_remap_by_values(const struct hatch_mesh *mesh, const uint32_t *point, float *values,
                                        struct hatch_arena *arena, struct hatch_arena *scratch,
                                        struct hatch_remap *remap, struct hatch_err *err) HATCH_MUST_USE;

/* Numbers vertices like hatch_mesh_weld, but only those that are also equal in three values each are one point.
 *   values  3 per vertex */
enum hatch_status hatch_remap_weld(const struct hatch_mesh *mesh, float *values, struct hatch_arena *scratch,
                                   uint32_t *vertex_to_point, uint32_t *point_count,
                                   struct hatch_err *err) HATCH_MUST_USE;

/* Makes a table of vertices that are equal in POSITION and TEXCOORD_0. The mesh must have both. Leaves temporary data
 * in arena. */
enum hatch_status hatch_remap_by_texcoord(const struct hatch_mesh *mesh, struct hatch_arena *arena,
                                          struct hatch_remap *remap, struct hatch_err *err) HATCH_MUST_USE;

/* Copies all attributes except texture coordinates to a mesh that has POSITION alone.
 *   origin_of  per vertex of `to`: the vertex of `from` that it copies */
enum hatch_status hatch_remap_attributes(const struct hatch_mesh *from, const uint32_t *origin_of,
                                         struct hatch_arena *arena, struct hatch_mesh *to,
                                         struct hatch_err *err) HATCH_MUST_USE;

#endif
