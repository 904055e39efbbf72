/* Private to the PLY reader: the header. */
#ifndef HATCH_IO_MESH_PLY_H
#define HATCH_IO_MESH_PLY_H

#include "io/mesh/text.h"

#define HATCH_PLY_ELEMENTS_MAX 16u
#define HATCH_PLY_PROPERTIES_MAX 64u

enum hatch_ply_type {
    HATCH_PLY_NONE,
    HATCH_PLY_INT8,
    HATCH_PLY_UINT8,
    HATCH_PLY_INT16,
    HATCH_PLY_UINT16,
    HATCH_PLY_INT32,
    HATCH_PLY_UINT32,
    HATCH_PLY_FLOAT32,
    HATCH_PLY_FLOAT64
};

/* Meaning of a property; HATCH_PLY_SKIP: not read. */
enum hatch_ply_use {
    HATCH_PLY_SKIP,
    HATCH_PLY_X,
    HATCH_PLY_Y,
    HATCH_PLY_Z,
    HATCH_PLY_NX,
    HATCH_PLY_NY,
    HATCH_PLY_NZ,
    HATCH_PLY_U,
    HATCH_PLY_V,
    HATCH_PLY_INDICES,
    HATCH_PLY_USES
};

struct hatch_ply_property {
    enum hatch_ply_type type;
    enum hatch_ply_type count_type; /* of a list; HATCH_PLY_NONE for a single number */
    enum hatch_ply_use use;
};

enum hatch_ply_kind { HATCH_PLY_OTHER, HATCH_PLY_VERTEX, HATCH_PLY_FACE, HATCH_PLY_STRIPS };

struct hatch_ply_element {
    enum hatch_ply_kind kind;
    char name[32];
    uint64_t count;
    uint32_t property_count;
    struct hatch_ply_property properties[HATCH_PLY_PROPERTIES_MAX];
};

struct hatch_ply_header {
    bool ascii, big_endian;
    uint32_t element_count;
    struct hatch_ply_element elements[HATCH_PLY_ELEMENTS_MAX];
};

/* Bytes of a binary number; 0 for HATCH_PLY_NONE. */
size_t hatch_ply_size(enum hatch_ply_type type);

/* Reads the header, including the line end_header; text is then at the body's first byte.
 * HATCH_BAD_INPUT with the line. */
enum hatch_status hatch_ply_read_header(struct hatch_mesh_text *text, struct hatch_ply_header *header,
                                        struct hatch_err *err) HATCH_MUST_USE;

#endif
