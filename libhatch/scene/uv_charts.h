/* Charts: the connected parts of a surface in texture space. */
#ifndef HATCH_SCENE_UV_CHARTS_H
#define HATCH_SCENE_UV_CHARTS_H

#include "mesh/mesh.h"

/* Joins the vertices of each chart into a set (mesh/fans.h): those of one face, and those that are equal in position
 * and texture coordinates.
 *   texcoord  two floats per vertex
 *   parent    out: vertex_count entries */
enum hatch_status hatch_uv_charts_join(const struct hatch_mesh *mesh, const float *texcoord,
                                       struct hatch_arena *scratch, uint32_t *parent,
                                       struct hatch_err *err) HATCH_MUST_USE;

#endif
