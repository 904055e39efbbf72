/* Reads files that hold a mesh and no scene: PLY (ascii, both binary orders), OBJ, OFF, STL (ascii, binary). Polygons
 * are triangulated as fans where a fan covers the polygon, else by ear clipping. */
#ifndef HATCH_IO_MESH_FILE_H
#define HATCH_IO_MESH_FILE_H

#include "base/bytes.h"
#include "mesh/mesh.h"

enum hatch_mesh_format {
    HATCH_MESH_UNKNOWN,
    HATCH_MESH_GLTF, /* JSON or GLB, which io/gltf/gltf.h reads */
    HATCH_MESH_PLY,
    HATCH_MESH_OBJ,
    HATCH_MESH_OFF,
    HATCH_MESH_STL
};

struct hatch_mesh_file {
    struct hatch_bytes bytes;
    enum hatch_mesh_format format;
};

/* Recognises a file's format by its content, else by the extension of its name.
 *   name  may be NULL */
enum hatch_mesh_format hatch_mesh_format_of(struct hatch_bytes file, const char *name);

/* Reads a mesh: POSITION, and NORMAL, TEXCOORD_0 and COLOR_0 where an OBJ, PLY or OFF has them, at vertices or at
 * corners of faces, at which vertices are then split. v is flipped, since it points upwards in these formats, but
 * downwards in glTF. Normals that only some vertices lack become those of faces; texture coordinates that some lack are
 * left out. Colours are decoded from sRGB; vertices without one are white, where others have some.
 *   file    its format is not HATCH_MESH_GLTF
 *   origin  out: subtracted from all positions before they become floats. On each axis it is the centre of the mesh if
 *           this is so far from 0 that floats are coarse for the mesh's size, else 0. NULL: nothing is subtracted
 *   notes   in, out: counts are added
 * HATCH_BAD_INPUT, with line or byte, for a malformed or truncated file, wrong counts, indices out of range, numbers
 * that are not finite, and files without faces. */
enum hatch_status hatch_mesh_read(struct hatch_mesh_file file, struct hatch_arena *arena, struct hatch_arena *scratch,
                                  struct hatch_mesh *mesh, double origin[3], struct hatch_mesh_notes *notes,
                                  struct hatch_err *err) HATCH_MUST_USE;

#endif
