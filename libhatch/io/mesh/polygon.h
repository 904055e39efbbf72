/* Private to the mesh readers: what they share beyond text. */
#ifndef HATCH_IO_MESH_POLYGON_H
#define HATCH_IO_MESH_POLYGON_H

#include "base/bytes.h"
#include "mesh/mesh.h"

/* A mesh under construction: faces are cut into triangles as they come, so every face's vertices must
 * have been read before it. */
struct hatch_faces {
    struct hatch_buffer indices; /* of uint32_t, in scratch */
    uint32_t face_count;
    uint32_t polygons_split;
    uint32_t lines_dropped; /* faces of less than three corners: points and lines */
    uint64_t work_left;     /* how many more steps concave polygons may cost */
    struct hatch_arena *scratch;
};

/* No faces yet; they will lie in scratch. */
struct hatch_faces hatch_faces_in(struct hatch_arena *scratch);

/* Adds one polygon: fans where they are proper triangulations, else by clipping ears. positions: where
 * the vertices are; point: the corners' indices into it; vertex: the corners' numbers in the mesh (may
 * be point). count: less than 3 make no face, which is counted. HATCH_LIMIT for concave polygons that are too large. */
enum hatch_status hatch_faces_add(struct hatch_faces *faces, const float *positions, const uint32_t *point,
                                  const uint32_t *vertex, uint32_t count, struct hatch_err *err) HATCH_MUST_USE;

/* Makes the mesh: positions and the indices are copied. Faces of less than three corners are noted as degenerate. */
enum hatch_status hatch_faces_finish(const struct hatch_faces *faces, const float *positions, uint32_t vertex_count,
                                     struct hatch_arena *arena, struct hatch_mesh *mesh, struct hatch_mesh_notes *notes,
                                     struct hatch_err *err) HATCH_MUST_USE;

/* Adds NORMAL, scaled to length 1, unless one of them has no length: those of such files are of no
 * use. normals: 3 floats a vertex. */
enum hatch_status hatch_faces_add_normals(const float *normals, struct hatch_arena *arena, struct hatch_mesh *mesh,
                                          struct hatch_err *err) HATCH_MUST_USE;

/* How long the word is that OFF files begin with: ST, C, N, each or none, and OFF. 0: it does not stand there. */
size_t hatch_off_word(const char *at, size_t left);

/* The readers, each as hatch_mesh_read for its format; origin is not NULL. */
typedef enum hatch_status (*hatch_mesh_reader)(struct hatch_bytes file, const double origin[3],
                                               struct hatch_arena *arena, struct hatch_arena *scratch,
                                               struct hatch_mesh *mesh, struct hatch_mesh_notes *notes,
                                               struct hatch_err *err);
enum hatch_status hatch_ply_read(struct hatch_bytes file, const double origin[3], struct hatch_arena *arena,
                                 struct hatch_arena *scratch, struct hatch_mesh *mesh, struct hatch_mesh_notes *notes,
                                 struct hatch_err *err) HATCH_MUST_USE;
enum hatch_status hatch_obj_read(struct hatch_bytes file, const double origin[3], struct hatch_arena *arena,
                                 struct hatch_arena *scratch, struct hatch_mesh *mesh, struct hatch_mesh_notes *notes,
                                 struct hatch_err *err) HATCH_MUST_USE;
enum hatch_status hatch_off_read(struct hatch_bytes file, const double origin[3], struct hatch_arena *arena,
                                 struct hatch_arena *scratch, struct hatch_mesh *mesh, struct hatch_mesh_notes *notes,
                                 struct hatch_err *err) HATCH_MUST_USE;
enum hatch_status hatch_stl_read(struct hatch_bytes file, const double origin[3], struct hatch_arena *arena,
                                 struct hatch_arena *scratch, struct hatch_mesh *mesh, struct hatch_mesh_notes *notes,
                                 struct hatch_err *err) HATCH_MUST_USE;

#endif
