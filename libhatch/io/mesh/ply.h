/* Private to the PLY reader: the header. */
#ifndef HATCH_IO_MESH_PLY_H
#define HATCH_IO_MESH_PLY_H

#include "io/mesh/text.h"

#define PLY_ELEMENTS_MAX 16u
#define PLY_PROPERTIES_MAX 64u

enum ply_type { PLY_NONE, PLY_INT8, PLY_UINT8, PLY_INT16, PLY_UINT16, PLY_INT32, PLY_UINT32, PLY_FLOAT32, PLY_FLOAT64 };

/* Meaning of a property; PLY_SKIP: not read. PLY_TEXCOORDS: u and v of each corner of a face. */
enum ply_use {
    PLY_SKIP,
    PLY_X,
    PLY_Y,
    PLY_Z,
    PLY_NX,
    PLY_NY,
    PLY_NZ,
    PLY_U,
    PLY_V,
    PLY_RED,
    PLY_GREEN,
    PLY_BLUE,
    PLY_ALPHA,
    PLY_INDICES,
    PLY_TEXCOORDS,
    PLY_USES
};

struct ply_property {
    enum ply_type type;
    enum ply_type count_type; /* type of a list's length; PLY_NONE for a single number */
    enum ply_use use;
};

enum ply_kind { PLY_OTHER, PLY_VERTEX, PLY_FACE, PLY_STRIPS };

struct ply_element {
    enum ply_kind kind;
    char name[32];
    uint64_t count;
    uint32_t property_count;
    struct ply_property properties[PLY_PROPERTIES_MAX];
};

struct ply_header {
    bool ascii, big_endian;
    uint32_t element_count;
    struct ply_element elements[PLY_ELEMENTS_MAX];
};

/* Reads the header, including the line end_header; text is then at the body's first byte.
 * HATCH_BAD_INPUT with the line. */
enum hatch_status hatch_ply_read_header(struct hatch_mesh_text *text, struct ply_header *header,
                                        struct hatch_err *err) HATCH_MUST_USE;

#endif
