/* Mesh files without a scene: PLY (ascii and both binary orders), OBJ, OFF, STL (ascii, binary); small
 * strict readers. Polygons are triangulated (convex fans; ear clipping for the others). */
#ifndef HATCH_IO_MESH_FILE_H
#define HATCH_IO_MESH_FILE_H

#include "base/bytes.h"
#include "mesh/mesh.h"

enum hatch_mesh_format {
    HATCH_MESH_UNKNOWN,
    HATCH_MESH_GLTF, /* JSON or GLB: read by io/gltf/gltf.h */
    HATCH_MESH_PLY,
    HATCH_MESH_OBJ,
    HATCH_MESH_OFF,
    HATCH_MESH_STL
};

/* By content first (magic words), then by the name's ending; name may be NULL. */
enum hatch_mesh_format hatch_mesh_format_of(struct hatch_bytes file, const char *name);

/* Reads one mesh: POSITION, and NORMAL and TEXCOORD_0 where the file has them (an OBJ's v is turned to
 * glTF's downward v). HATCH_BAD_INPUT with line or offset for anything malformed: cut files, counts
 * that lie, indices out of range, numbers that are not finite, tristrips without faces, point clouds.
 * origin: what was taken off all positions before they became floats; zeros, but where the mesh lies so far out that
 * floats are coarse beside its size: then its middle, as floats hold it. NULL: nothing is taken off. */
enum hatch_status hatch_mesh_read(struct hatch_bytes file, enum hatch_mesh_format format, struct hatch_arena *arena,
                                  struct hatch_arena *scratch, struct hatch_mesh *mesh, double origin[3],
                                  struct hatch_mesh_notes *notes, struct hatch_err *err) HATCH_MUST_USE;

#endif
