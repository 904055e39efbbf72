/* Private to the mesh readers: triangulation, and the readers themselves. */
#ifndef HATCH_IO_MESH_POLYGON_H
#define HATCH_IO_MESH_POLYGON_H

#include "base/bytes.h"
#include "mesh/mesh.h"

/* Triangles of a mesh being read. */
struct hatch_faces {
    struct hatch_buffer indices; /* array of uint32_t, in scratch */
    uint32_t face_count;
    uint32_t polygons_split;
    uint32_t lines_dropped; /* faces of less than three corners */
    uint64_t steps_left;    /* of ear clipping, in all polygons together */
    struct hatch_arena *scratch;
};

struct hatch_faces hatch_faces_in(struct hatch_arena *scratch);

/* Triangulates a polygon and adds its triangles. Fewer than 3 corners are counted and dropped.
 *   positions  3 floats per point
 *   point      count indices into positions, which must have been read
 *   vertex     count indices of the mesh's vertices; may be point
 * HATCH_LIMIT also for concave polygons that are too large. */
enum hatch_status hatch_faces_add(struct hatch_faces *faces, const float *positions, const uint32_t *point,
                                  const uint32_t *vertex, uint32_t count, struct hatch_err *err) HATCH_MUST_USE;

/* Makes the mesh, with copies of positions and indices, and counts up notes; dropped faces count as
 * degenerate.
 *   positions  3 floats per vertex
 * HATCH_BAD_INPUT without faces. */
enum hatch_status hatch_faces_finish(const struct hatch_faces *faces, const float *positions, uint32_t vertex_count,
                                     struct hatch_arena *arena, struct hatch_mesh *mesh, struct hatch_mesh_notes *notes,
                                     struct hatch_err *err) HATCH_MUST_USE;

/* Adds NORMAL, normalised, unless one of the normals is zero: such files' normals are unreliable.
 *   normals  3 floats per vertex */
enum hatch_status hatch_faces_add_normals(const float *normals, struct hatch_arena *arena, struct hatch_mesh *mesh,
                                          struct hatch_err *err) HATCH_MUST_USE;

/* Length of the keyword that OFF files begin with: any of ST, C, N in this order, then OFF; else 0. */
size_t hatch_off_keyword(const char *at, size_t size);

/* The readers: hatch_mesh_read for one format. origin is not NULL. */
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
