/* Derivatives of a surface's position by its texture coordinates, per vertex. */
#ifndef HATCH_MESH_UV_TANGENTS_H
#define HATCH_MESH_UV_TANGENTS_H

#include "mesh/mesh.h"

/* Computes dP/du and dP/dv at each vertex (the columns of T, Szécsi & Szirányi 2014, §5.1): the mean over the faces
 * around it, weighted by area, so that strokes have one scale on both sides of an edge.
 *   mesh      has TEXCOORD_0
 *   scratch   keeps the result and temporaries
 *   tangents  out: 6 floats per vertex; zero where texture coordinates are degenerate */
enum hatch_status hatch_uv_tangents(const struct hatch_mesh *mesh, struct hatch_arena *scratch, float **tangents,
                                    struct hatch_err *err) HATCH_MUST_USE;

/* Returns the largest distance of TEXCOORD_0 from 0 0, converted to a length on the mesh, which bounds the rounding
 * errors of texture coordinates; 0 where texture coordinates have no area.
 *   mesh  has TEXCOORD_0 */
double hatch_uv_reach(const struct hatch_mesh *mesh);

#endif
