/* PLY (Turk, Stanford 1994): ascii and both binary orders, vertices with any properties, faces and triangle strips.
 * Only read_number, skip_property and the size checks distinguish ascii from binary. */

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "io/mesh/corners.h"
#include "io/mesh/ply.h"
#include "io/mesh/polygon.h"

/* Returns the size in bytes of a binary number; 0 for PLY_NONE. */
static size_t size_of(enum ply_type type)
{
    static const size_t sizes[] = {0, 1, 1, 2, 2, 4, 4, 4, 8};
    return sizes[type];
}

struct ply {
    struct ply_header header;
    const double *origin;
    struct hatch_mesh_text text;       /* ascii */
    struct hatch_reader reader;        /* binary */
    const struct ply_element *element; /* the element being read */
    uint64_t item;                     /* index of the item in element, for messages */
    struct hatch_arena *scratch;
    uint32_t vertex_count;
    float *positions, *normals, *texcoords, *colors; /* NULL if the file has none */
    bool splits;                                     /* faces have texture coordinates */
    struct hatch_corners corners; /* if it splits: parts are the vertex of the file, and the bits of u and v */
    /* Of the face being read: its vertices in the file and in the mesh, and u and v of each corner. */
    struct hatch_buffer points, used, uv;
    struct hatch_faces faces;
};

static enum hatch_status fail(const struct ply *p, struct hatch_err *err, const char *what)
{
    if (p->header.ascii)
        return hatch_fail(err, HATCH_BAD_INPUT, "line %u: %s %llu: %s", p->text.line, p->element->name,
                          (unsigned long long)p->item, what);
    return hatch_fail(err, HATCH_BAD_INPUT, "byte %zu: %s %llu: %s", p->reader.at, p->element->name,
                      (unsigned long long)p->item, what);
}

static double read_binary(struct hatch_reader *reader, enum ply_type type)
{
    switch (type) {
    case PLY_INT8:
        return (int8_t)hatch_read_u8(reader);
    case PLY_UINT8:
        return hatch_read_u8(reader);
    case PLY_INT16:
        return (int16_t)hatch_read_u16(reader);
    case PLY_UINT16:
        return hatch_read_u16(reader);
    case PLY_INT32:
        return (int32_t)hatch_read_u32(reader);
    case PLY_UINT32:
        return hatch_read_u32(reader);
    case PLY_FLOAT32:
        return (double)hatch_read_f32(reader);
    default:
        return hatch_read_f64(reader);
    }
}

/* Reads the next number; doubles represent the values of all types exactly. */
static enum hatch_status read_number(struct ply *p, enum ply_type type, double *number, struct hatch_err *err)
{
    if (p->header.ascii) {
        struct hatch_text word = hatch_mesh_text_any_word(&p->text);
        if (word.length == 0)
            return fail(p, err, "the file is truncated");
        return hatch_text_decimal(word, number) ? HATCH_OK : fail(p, err, "not a number");
    }
    *number = read_binary(&p->reader, type);
    return p->reader.cut ? fail(p, err, "the file is truncated") : HATCH_OK;
}

/* Reads the next number as a float; NAN where a word of an ascii file is none. */
static enum hatch_status read_float(struct ply *p, enum ply_type type, float *number, struct hatch_err *err)
{
    double value;
    if (p->header.ascii) {
        struct hatch_text word = hatch_mesh_text_any_word(&p->text);
        if (word.length == 0)
            return fail(p, err, "the file is truncated");
        if (!hatch_text_decimal(word, &value))
            value = NAN;
    } else {
        HATCH_TRY(read_number(p, type, &value, err));
    }
    *number = (float)value;
    return HATCH_OK;
}

/* Returns the minimum size in bytes of an item of an element; in ascii, a number takes at least a digit and a
 * separator. */
static size_t min_size(const struct ply *p, const struct ply_element *element)
{
    size_t size = 0;
    for (uint32_t i = 0; i < element->property_count; i++) {
        const struct ply_property *property = &element->properties[i];
        enum ply_type type = property->count_type ? property->count_type : property->type;
        size += p->header.ascii ? 2 : size_of(type);
    }
    return size;
}

static enum hatch_status check_count(struct ply *p, struct hatch_err *err)
{
    size_t remaining = p->header.ascii ? hatch_mesh_text_remaining(&p->text) : hatch_reader_left(&p->reader);
    size_t smallest = min_size(p, p->element);
    if (!smallest && p->element->kind != PLY_OTHER && p->element->count)
        return hatch_fail(err, HATCH_BAD_INPUT, "element %s: no properties", p->element->name);
    if (smallest && p->element->count > remaining / smallest + 1)
        return hatch_fail(err, HATCH_BAD_INPUT,
                          "element %s: %llu items of at least %zu bytes do not fit into %zu bytes", p->element->name,
                          (unsigned long long)p->element->count, smallest, remaining);
    return HATCH_OK;
}

/* Reads a list's length and checks it against the remaining bytes. */
static enum hatch_status read_length(struct ply *p, const struct ply_property *property, uint32_t *length,
                                     struct hatch_err *err)
{
    double number;
    HATCH_TRY(read_number(p, property->count_type, &number, err));
    size_t longest = p->header.ascii ? hatch_mesh_text_remaining(&p->text) / 2 + 1
                                     : hatch_reader_left(&p->reader) / size_of(property->type);
    if (!(number >= 0 && number <= (double)longest && number < (double)INT32_MAX))
        return fail(p, err, "a list is longer than the file");
    if (floor(number) < number)
        return fail(p, err, "the length of a list is not an integer");
    *length = (uint32_t)number;
    return HATCH_OK;
}

/* Skips a property. In ascii its value may be any word, since scanners write "nan" for an unknown quality. */
static enum hatch_status skip_property(struct ply *p, const struct ply_property *property, struct hatch_err *err)
{
    uint32_t length = 1;
    double number;
    if (property->count_type)
        HATCH_TRY(read_length(p, property, &length, err));
    for (uint32_t i = 0; i < length; i++)
        if (!p->header.ascii)
            HATCH_TRY(read_number(p, property->type, &number, err));
        else if (hatch_mesh_text_any_word(&p->text).length == 0)
            return fail(p, err, "the file is truncated");
    return HATCH_OK;
}

static enum hatch_status allocate_vertices(struct ply *p, struct hatch_err *err)
{
    bool has[PLY_USES] = {false};
    for (uint32_t i = 0; i < p->element->property_count; i++)
        has[p->element->properties[i].use] = true;
    if (p->positions)
        return fail(p, err, "the element vertex occurs twice");
    if (!has[PLY_X] || !has[PLY_Y] || !has[PLY_Z])
        return hatch_fail(err, HATCH_BAD_INPUT, "element vertex: no properties x, y and z");
    if (p->element->count > INT32_MAX)
        return hatch_fail(err, HATCH_LIMIT, "element vertex: more than %d vertices", INT32_MAX);
    p->vertex_count = (uint32_t)p->element->count;
    HATCH_TRY(HATCH_ALLOC(p->scratch, &p->positions, (size_t)p->vertex_count * 3, err));
    if (has[PLY_NX] && has[PLY_NY] && has[PLY_NZ]) {
        HATCH_TRY(HATCH_ALLOC(p->scratch, &p->normals, (size_t)p->vertex_count * 3, err));
    }
    if (has[PLY_U] && has[PLY_V]) {
        HATCH_TRY(HATCH_ALLOC(p->scratch, &p->texcoords, (size_t)p->vertex_count * 2, err));
    }
    if (has[PLY_RED] && has[PLY_GREEN] && has[PLY_BLUE]) {
        HATCH_TRY(HATCH_ALLOC(p->scratch, &p->colors, (size_t)p->vertex_count * 4, err));
        for (size_t v = 0; v < p->vertex_count && !has[PLY_ALPHA]; v++)
            p->colors[v * 4 + 3] = 1;
    }
    return HATCH_OK;
}

/* Reads a component of a vertex's colour; integers count up to the largest of their type. */
static enum hatch_status read_color(struct ply *p, const struct ply_property *property, struct hatch_err *err)
{
    static const float most[] = {1, INT8_MAX, UINT8_MAX, INT16_MAX, UINT16_MAX, (float)INT32_MAX, (float)UINT32_MAX,
                                 1, 1};
    float number = 0;
    HATCH_TRY(read_float(p, property->type, &number, err));
    if (p->colors)
        p->colors[p->item * 4 + (uint64_t)(property->use - PLY_RED)] = number / most[property->type];
    return HATCH_OK;
}

static enum hatch_status read_vertices(struct ply *p, struct hatch_err *err)
{
    HATCH_TRY(allocate_vertices(p, err));
    for (p->item = 0; p->item < p->element->count; p->item++)
        for (uint32_t i = 0; i < p->element->property_count; i++) {
            const struct ply_property *property = &p->element->properties[i];
            double number;
            if (property->use == PLY_SKIP) {
                HATCH_TRY(skip_property(p, property, err));
                continue;
            }
            if (property->use >= PLY_RED) {
                HATCH_TRY(read_color(p, property, err));
                continue;
            }
            HATCH_TRY(read_number(p, property->type, &number, err));
            float value = (float)number;
            if (!isfinite(value))
                return fail(p, err, "a number is not finite");
            size_t v = (size_t)p->item, k = (size_t)property->use;
            if (k <= PLY_Z)
                p->positions[v * 3 + k - PLY_X] = (float)(number - p->origin[k - PLY_X]);
            else if (k <= PLY_NZ && p->normals)
                p->normals[v * 3 + k - PLY_NX] = value;
            else if (k >= PLY_U && p->texcoords)
                p->texcoords[v * 2 + k - PLY_U] = value;
        }
    return HATCH_OK;
}

/* Reads a list of corners. In strips -1 begins a new strip and is stored as UINT32_MAX. */
static enum hatch_status read_corners(struct ply *p, const struct ply_property *property, struct hatch_err *err)
{
    uint32_t length;
    HATCH_TRY(read_length(p, property, &length, err));
    p->points.size = 0;
    for (uint32_t i = 0; i < length; i++) {
        double number;
        HATCH_TRY(read_number(p, property->type, &number, err));
        bool restart = p->element->kind == PLY_STRIPS && number == -1;
        if (!restart && !(number >= 0 && number < p->vertex_count && floor(number) == number)) {
            char what[80];
            snprintf(what, sizeof what, "vertex index %.10g, want a whole number below %u", number, p->vertex_count);
            return fail(p, err, what);
        }
        uint32_t corner = restart ? UINT32_MAX : (uint32_t)number;
        HATCH_TRY(hatch_buffer_add(&p->points, &corner, sizeof corner, err));
    }
    return HATCH_OK;
}

static enum hatch_status read_uv(struct ply *p, const struct ply_property *property, struct hatch_err *err)
{
    uint32_t length;
    float number;
    HATCH_TRY(read_length(p, property, &length, err));
    for (uint32_t i = 0; i < length; i++) {
        HATCH_TRY(read_float(p, property->type, &number, err));
        HATCH_TRY(hatch_buffer_add(&p->uv, &number, sizeof number, err));
    }
    return HATCH_OK;
}

/* Finds the texture coordinates of a corner of the face being read, of which the face or the vertex may have some. */
static const float *uv_of(const struct ply *p, uint32_t corner, uint32_t count, uint32_t point)
{
    const float *uv = p->uv.size == 2 * count * sizeof *uv
                          ? (const float *)(const void *)p->uv.data + 2 * (size_t)corner
                      : p->texcoords ? p->texcoords + 2 * (size_t)point
                                     : NULL;
    return uv && isfinite(uv[0]) && isfinite(uv[1]) ? uv : NULL;
}

/* Adds a face.
 *   point  indices of its vertices in the file */
static enum hatch_status add_face(struct ply *p, const uint32_t *point, uint32_t count, struct hatch_err *err)
{
    if (!p->splits)
        return hatch_faces_add(&p->faces, p->positions, point, point, count, err);
    p->used.size = 0;
    for (uint32_t i = 0; i < count; i++) {
        struct hatch_corner corner = {{point[i], HATCH_CORNER_ABSENT, HATCH_CORNER_ABSENT}};
        const float *uv = uv_of(p, i, count, point[i]);
        uint32_t vertex;
        for (int k = 0; uv && k < 2; k++) {
            float number = uv[k] + 0.0f; /* -0 equals 0 */
            memcpy(&corner.part[1 + k], &number, sizeof number);
        }
        HATCH_TRY(hatch_corners_add(&p->corners, &corner, &vertex, err));
        HATCH_TRY(hatch_buffer_add(&p->used, &vertex, sizeof vertex, err));
    }
    return hatch_faces_add(&p->faces, p->positions, point, (const uint32_t *)(const void *)p->used.data, count, err);
}

/* Adds the triangles of one or more strips. Odd triangles of a strip are reversed, so that all have the same
 * orientation. Triangles with a repeated corner only join strips and are left out. */
static enum hatch_status add_strips(struct ply *p, const uint32_t *corner, uint32_t count, struct hatch_err *err)
{
    uint32_t start = 0;
    for (uint32_t i = 0; i < count; i++) {
        if (corner[i] == UINT32_MAX)
            start = i + 1;
        if (i < start + 2 || corner[i] == UINT32_MAX)
            continue;
        bool odd = (i - start) % 2 == 1;
        const uint32_t triangle[3] = {corner[i - 2], corner[odd ? i : i - 1], corner[odd ? i - 1 : i]};
        if (triangle[0] == triangle[1] || triangle[1] == triangle[2] || triangle[2] == triangle[0])
            continue;
        HATCH_TRY(add_face(p, triangle, 3, err));
    }
    return HATCH_OK;
}

static enum hatch_status read_faces(struct ply *p, struct hatch_err *err)
{
    if (!p->positions)
        return hatch_fail(err, HATCH_BAD_INPUT, "element %s: must follow the element vertex", p->element->name);
    for (p->item = 0; p->item < p->element->count; p->item++) {
        p->points.size = p->uv.size = 0;
        for (uint32_t i = 0; i < p->element->property_count; i++) {
            const struct ply_property *property = &p->element->properties[i];
            if (property->use == PLY_INDICES)
                HATCH_TRY(read_corners(p, property, err));
            else if (property->use == PLY_TEXCOORDS)
                HATCH_TRY(read_uv(p, property, err));
            else
                HATCH_TRY(skip_property(p, property, err));
        }
        const uint32_t *point = (const uint32_t *)(const void *)p->points.data;
        uint32_t count = (uint32_t)(p->points.size / sizeof *point);
        HATCH_TRY(p->element->kind == PLY_STRIPS ? add_strips(p, point, count, err) : add_face(p, point, count, err));
    }
    return HATCH_OK;
}

static enum hatch_status skip_element(struct ply *p, struct hatch_err *err)
{
    for (p->item = 0; p->element->property_count && p->item < p->element->count; p->item++)
        for (uint32_t i = 0; i < p->element->property_count; i++)
            HATCH_TRY(skip_property(p, &p->element->properties[i], err));
    return HATCH_OK;
}

static enum hatch_status read_body(struct ply *p, struct hatch_err *err)
{
    for (uint32_t e = 0; e < p->header.element_count; e++) {
        p->element = &p->header.elements[e];
        p->item = 0;
        HATCH_TRY(check_count(p, err));
        if (p->element->kind == PLY_VERTEX)
            HATCH_TRY(read_vertices(p, err));
        else if (p->element->kind == PLY_OTHER)
            HATCH_TRY(skip_element(p, err));
        else
            HATCH_TRY(read_faces(p, err));
    }
    if (!p->positions)
        return hatch_fail(err, HATCH_BAD_INPUT, "no element vertex");
    return HATCH_OK;
}

static bool has_uv_at_corners(const struct ply_header *header)
{
    for (uint32_t e = 0; e < header->element_count; e++)
        for (uint32_t i = 0; i < header->elements[e].property_count; i++)
            if (header->elements[e].properties[i].use == PLY_TEXCOORDS)
                return true;
    return false;
}

/* Replaces the vertices of the file by those of the table of corners. */
static enum hatch_status split(struct ply *p, struct hatch_vertices *vertices, uint32_t *unused, struct hatch_err *err)
{
    float *uv;
    HATCH_TRY(hatch_corners_count_unused(&p->corners, p->vertex_count, unused, err));
    HATCH_TRY(hatch_corners_gather(&p->corners, 0, p->positions, 3, 0, &vertices->positions, err));
    if (p->normals)
        HATCH_TRY(hatch_corners_gather(&p->corners, 0, p->normals, 3, 0, &vertices->normals, err));
    if (p->colors)
        HATCH_TRY(hatch_corners_gather(&p->corners, 0, p->colors, 4, 0, &vertices->colors, err));
    HATCH_TRY(HATCH_ALLOC(p->scratch, &uv, 2 * (size_t)p->corners.count, err));
    for (uint32_t v = 0; v < p->corners.count; v++) /* the bits of HATCH_CORNER_ABSENT are a NAN */
        memcpy(&uv[2 * (size_t)v], &hatch_corners_list(&p->corners)[v].part[1], 2 * sizeof *uv);
    vertices->texcoords = uv;
    vertices->count = p->corners.count;
    return HATCH_OK;
}

enum hatch_status hatch_ply_read(struct hatch_bytes file, const double origin[3], struct hatch_arena *arena,
                                 struct hatch_arena *scratch, struct hatch_mesh *mesh, struct hatch_mesh_notes *notes,
                                 struct hatch_err *err)
{
    struct ply *p;
    HATCH_TRY(HATCH_ALLOC(scratch, &p, 1, err));
    p->scratch = p->points.arena = p->used.arena = p->uv.arena = scratch;
    p->corners = hatch_corners_in(scratch);
    p->faces = hatch_faces_in(scratch);
    p->origin = origin;
    p->text = hatch_mesh_text_of(file);
    HATCH_TRY(hatch_ply_read_header(&p->text, &p->header, err));
    p->reader = hatch_reader_of(file);
    p->reader.big_endian = p->header.big_endian;
    p->reader.at = (size_t)(p->text.at - (const char *)file.data);
    p->splits = has_uv_at_corners(&p->header);
    HATCH_TRY(read_body(p, err));
    struct hatch_vertices vertices = {p->vertex_count, p->positions, p->normals, p->texcoords, p->colors};
    if (p->splits && p->corners.count > 0) {
        HATCH_TRY(split(p, &vertices, &notes->unreferenced_dropped, err));
        notes->numbers_end = p->vertex_count;
        HATCH_TRY(hatch_corners_numbers(&p->corners, arena, &notes->numbers, err));
    }
    return hatch_faces_finish(&p->faces, &vertices, arena, mesh, notes, err);
}
