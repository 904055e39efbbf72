/* OpenMesh: decimation, and a second opinion on connectivity. C++ behind a C header; meshes go in and
 * come out whole. */
#ifndef HATCH_IO_OPENMESH_H
#define HATCH_IO_OPENMESH_H

#include "mesh/mesh.h"

/* Reduces a mesh to at most face_count faces, or as few as its topology allows, by collapsing edges in
 * the order of their quadric error (Garland & Heckbert, "Surface simplification using quadric error
 * metrics", SIGGRAPH 1997). Works on welded positions; the result has POSITION alone. Faces that would
 * give an edge a third face are left out first: their number is in *left_out (may be NULL). face_count:
 * at least 1. HATCH_BAD_INPUT when no face is left. */
enum hatch_status hatch_mesh_decimate(const struct hatch_mesh *mesh, uint32_t face_count, struct hatch_arena *arena,
                                      struct hatch_arena *scratch, struct hatch_mesh *out, uint32_t *left_out,
                                      struct hatch_err *err) HATCH_MUST_USE;

/* The surface as OpenMesh sees it, for tests of our own figures. */
struct hatch_connectivity {
    uint32_t points, edges, faces; /* euler = points - edges + faces; points that no face uses not counted */
    uint32_t boundary_loops;
    uint32_t left_out; /* faces that do not fit into a manifold */
};

/* Faces with a repeated corner or that would make an edge of three are left out and counted. */
enum hatch_status hatch_mesh_connectivity(const struct hatch_mesh *mesh, struct hatch_arena *scratch,
                                          struct hatch_connectivity *connectivity,
                                          struct hatch_err *err) HATCH_MUST_USE;

#endif
