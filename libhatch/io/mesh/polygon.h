/* Private to the mesh readers: triangulation, and the readers themselves. */
#ifndef HATCH_IO_MESH_POLYGON_H
#define HATCH_IO_MESH_POLYGON_H

#include "base/bytes.h"
#include "mesh/mesh.h"

/* The triangles of a mesh while it is read. */
struct hatch_faces {
    struct hatch_buffer indices; /* array of uint32_t, in scratch */
    uint32_t face_count;
    uint32_t polygons_split;
    uint32_t lines_dropped; /* faces of fewer than three corners */
    uint64_t steps_left;    /* steps of ear clipping that are left for all polygons together */
    struct hatch_arena *scratch;
};

struct hatch_faces hatch_faces_in(struct hatch_arena *scratch);

/* Triangulates a polygon and adds its triangles. A polygon of fewer than three corners is dropped and counted.
 *   positions  3 floats per point
 *   point      count indices into positions, which must have been read
 *   vertex     count indices of the mesh's vertices; may be point
 * HATCH_LIMIT also for concave polygons that are too large. */
enum hatch_status hatch_faces_add(struct hatch_faces *faces, const float *positions, const uint32_t *point,
                                  const uint32_t *vertex, uint32_t count, struct hatch_err *err) HATCH_MUST_USE;

/* The vertices of a file. */
struct hatch_vertices {
    uint32_t count;
    const float *positions; /* 3 each */
    const float *normals;   /* 3 each, of any length; 0 0 0 where the file gives none. NULL: none anywhere */
    const float *texcoords; /* 2 each, v upwards; NAN where the file gives none. NULL: none anywhere */
    const float *colors;    /* 4 each, sRGB and alpha, of 0 .. 1; NAN where the file gives none. NULL: none anywhere */
};

/* Makes the mesh of faces and vertices, and adds to the counts in notes; dropped polygons count as degenerate. NORMAL
 * has unit vectors; missing ones become those of faces, if there are others. TEXCOORD_0 is left out if some are
 * missing. COLOR_0 is linear, and white where it is missing. HATCH_BAD_INPUT without faces. */
enum hatch_status hatch_faces_finish(const struct hatch_faces *faces, const struct hatch_vertices *vertices,
                                     struct hatch_arena *arena, struct hatch_mesh *mesh, struct hatch_mesh_notes *notes,
                                     struct hatch_err *err) HATCH_MUST_USE;

/* Returns the length of the keyword that begins an OFF file: any of ST, C and N, then OFF; 0 if there is none. */
size_t hatch_off_keyword(const char *at, size_t size);

/* Returns whether a file has the size that a binary STL file with its number of triangles has. */
bool hatch_stl_has_size(struct hatch_bytes file);

/* Returns whether the first word is "solid", in either case: STL as text has that, and some binary files, too. */
bool hatch_stl_begins(struct hatch_bytes file);

/* The readers of the formats. Arguments are those of hatch_mesh_read, except that origin is an input, subtracted from
 * all positions. */
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
