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

/* Makes a table of vertices that are equal in POSITION and in three values each. -0 equals 0.
 *   values  3 per vertex
 *   remap   out: its arrays are in arena, which may be the scratch arena */
enum hatch_status hatch_remap_by_values(const struct hatch_mesh *mesh, float *values, struct hatch_arena *arena,
                                        struct hatch_arena *scratch, struct hatch_remap *remap,
                                        struct hatch_err *err) HATCH_MUST_USE;

/* Makes a table of vertices that are equal in POSITION and NORMAL. The mesh must have both.
 *   remap  out: its arrays are in arena */
enum hatch_status hatch_remap_by_normal(const struct hatch_mesh *mesh, struct hatch_arena *arena,
                                        struct hatch_arena *scratch, struct hatch_remap *remap,
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
