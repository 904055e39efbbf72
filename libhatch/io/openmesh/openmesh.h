/* Decimation of meshes by OpenMesh, and its counts of a mesh's elements, with which tests check libhatch's own. */
#ifndef HATCH_IO_OPENMESH_OPENMESH_H
#define HATCH_IO_OPENMESH_OPENMESH_H

#include "mesh/mesh.h"

/* Reduces a mesh to at most face_count faces, or as few as its topology allows, by collapsing edges in the order of
 * their quadric error (Garland & Heckbert, "Surface simplification using quadric error metrics", SIGGRAPH 1997).
 * Vertices at one position are welded.
 *   face_count  at least 1
 *   out         out: POSITION only
 *   left_out    out: number of faces that were dropped first: those with a repeated corner, and those that OpenMesh
 *               refuses as non-manifold; may be NULL
 * HATCH_BAD_INPUT when no face remains. */
enum hatch_status hatch_mesh_decimate(const struct hatch_mesh *mesh, uint32_t face_count, struct hatch_arena *arena,
                                      struct hatch_arena *scratch, struct hatch_mesh *out, uint32_t *left_out,
                                      struct hatch_err *err) HATCH_MUST_USE;

/* Counts made by OpenMesh, to test libhatch's own. */
struct hatch_connectivity {
    uint32_t points, edges, faces; /* points used by a face; Euler characteristic: points - edges + faces */
    uint32_t boundary_loops;
    uint32_t left_out; /* faces with a repeated corner, or refused by OpenMesh as non-manifold */
};

/* Counts the elements of a mesh with vertices at one position welded.
 * HATCH_BAD_INPUT when no face remains. */
enum hatch_status hatch_mesh_connectivity(const struct hatch_mesh *mesh, struct hatch_arena *scratch,
                                          struct hatch_connectivity *connectivity,
                                          struct hatch_err *err) HATCH_MUST_USE;

#endif
