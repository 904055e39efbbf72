/* Makes meshes coarser. A point collapses onto a neighbour, as long as the surface stays within a tolerance of every
 * point that has been removed (order: Garland & Heckbert, "Surface simplification using quadric error metrics",
 * SIGGRAPH 1997; tolerance: Klein, Liebich & Strasser, "Mesh reduction with error control", Visualization 1996).
 *
 * The vertices of the result are vertices of the mesh, with all their attributes. Borders of texture coordinates, of
 * normals and of meshes keep their points together: a point on such a border moves along it, on all sides at once. */
#ifndef HATCH_COARSE_COARSE_H
#define HATCH_COARSE_COARSE_H

#include "mesh/mesh.h"

/* Meshes whose borders may touch: the primitives of one glTF mesh. */
struct hatch_coarse_part {
    const struct hatch_mesh *mesh;
    const double *tolerance;    /* per vertex: how far the surface may move there, in mesh units; over 0 */
    const float *normal_cosine; /* per vertex, hatch_coarse_make_loosely: least cosine of the angle between its NORMAL
                                   and that of a new face there; NULL: -1 */
};

/* Makes meshes as coarse as their tolerances allow.
 *   out          out: one mesh per part, in arena; it has no faces if all of the part's have a repeated point */
enum hatch_status hatch_coarse_make(const struct hatch_coarse_part *parts, uint32_t part_count,
                                    struct hatch_arena *arena, struct hatch_arena *scratch, struct hatch_mesh *out,
                                    struct hatch_err *err) HATCH_MUST_USE;

/* The same in less time: a collapse is judged by the mean distance of the planes of removed faces, the attributes of
 * the point that is removed, and the shapes and normals of the faces that remain. This bounds no distance. */
enum hatch_status hatch_coarse_make_loosely(const struct hatch_coarse_part *parts, uint32_t part_count,
                                            struct hatch_arena *arena, struct hatch_arena *scratch,
                                            struct hatch_mesh *out, struct hatch_err *err) HATCH_MUST_USE;

#endif
