/* Derivatives of a surface's position with respect to its texture coordinates, per vertex. */
#ifndef HATCH_MESH_UV_TANGENTS_H
#define HATCH_MESH_UV_TANGENTS_H

#include "mesh/mesh.h"

/* Computes dP/du and dP/dv at each vertex (the columns of T, Szécsi & Szirányi 2014, §5.1): the means over the faces
 * around it, weighted by area, so that strokes have one scale on both sides of an edge.
 *   mesh      has TEXCOORD_0
 *   scratch   for the result and for temporary data
 *   tangents  out: 6 floats per vertex; zero where texture coordinates are degenerate */
enum hatch_status hatch_uv_tangents(const struct hatch_mesh *mesh, struct hatch_arena *scratch, float **tangents,
                                    struct hatch_err *err) HATCH_MUST_USE;

/* Returns the largest absolute value of u and v in TEXCOORD_0, converted to a length on the mesh; 0 if the texture
 * coordinates cover no area. The rounding errors of texture coordinates are proportional to it.
 *   mesh  has TEXCOORD_0 */
double hatch_uv_reach(const struct hatch_mesh *mesh);

#endif
