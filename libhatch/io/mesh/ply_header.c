#include <string.h>

#include "io/mesh/ply.h"

static enum ply_type type_of(struct hatch_text word)
{
    static const struct {
        const char *name;
        enum ply_type type;
    } names[] = {
        {"char", PLY_INT8},     {"int8", PLY_INT8},       {"uchar", PLY_UINT8},    {"uint8", PLY_UINT8},
        {"short", PLY_INT16},   {"int16", PLY_INT16},     {"ushort", PLY_UINT16},  {"uint16", PLY_UINT16},
        {"int", PLY_INT32},     {"int32", PLY_INT32},     {"uint", PLY_UINT32},    {"uint32", PLY_UINT32},
        {"float", PLY_FLOAT32}, {"float32", PLY_FLOAT32}, {"double", PLY_FLOAT64}, {"float64", PLY_FLOAT64},
    };
    for (size_t i = 0; i < sizeof names / sizeof *names; i++)
        if (hatch_text_is(word, names[i].name))
            return names[i].type;
    return PLY_NONE;
}

static enum ply_use use_of(enum ply_kind kind, bool list, struct hatch_text word)
{
    static const struct {
        const char *name;
        enum ply_use use;
    } names[] = {{"x", PLY_X},
                 {"y", PLY_Y},
                 {"z", PLY_Z},
                 {"nx", PLY_NX},
                 {"ny", PLY_NY},
                 {"nz", PLY_NZ},
                 {"u", PLY_U},
                 {"v", PLY_V},
                 {"s", PLY_U},
                 {"t", PLY_V},
                 {"texture_u", PLY_U},
                 {"texture_v", PLY_V},
                 {"red", PLY_RED},
                 {"green", PLY_GREEN},
                 {"blue", PLY_BLUE},
                 {"alpha", PLY_ALPHA},
                 {"diffuse_red", PLY_RED},
                 {"diffuse_green", PLY_GREEN},
                 {"diffuse_blue", PLY_BLUE}};
    if (kind == PLY_FACE && list && hatch_text_is(word, "texcoord"))
        return PLY_TEXCOORDS;
    if ((kind == PLY_FACE || kind == PLY_STRIPS) && list)
        return hatch_text_is(word, "vertex_indices") || hatch_text_is(word, "vertex_index") ? PLY_INDICES : PLY_SKIP;
    for (size_t i = 0; kind == PLY_VERTEX && !list && i < sizeof names / sizeof *names; i++)
        if (hatch_text_is(word, names[i].name))
            return names[i].use;
    return PLY_SKIP;
}

static enum hatch_status read_format(struct hatch_mesh_text *text, struct ply_header *header, struct hatch_err *err)
{
    struct hatch_text format = hatch_mesh_text_word(text), version = hatch_mesh_text_word(text);
    header->ascii = hatch_text_is(format, "ascii");
    header->big_endian = hatch_text_is(format, "binary_big_endian");
    if ((!header->ascii && !header->big_endian && !hatch_text_is(format, "binary_little_endian")) ||
        !hatch_text_is(version, "1.0"))
        return hatch_fail(err, HATCH_BAD_INPUT, "line %u: unknown format %.*s", text->line,
                          hatch_mesh_text_shown(format), format.at);
    return HATCH_OK;
}

static enum hatch_status read_element(struct hatch_mesh_text *text, struct ply_header *header, struct hatch_err *err)
{
    if (header->element_count == PLY_ELEMENTS_MAX)
        return hatch_fail(err, HATCH_BAD_INPUT, "line %u: more than %u elements", text->line, PLY_ELEMENTS_MAX);
    struct hatch_text name = hatch_mesh_text_word(text), number = hatch_mesh_text_word(text);
    struct ply_element *element = &header->elements[header->element_count];
    int64_t count;
    if (name.length >= sizeof element->name || !hatch_mesh_text_integer(number, &count) || count < 0)
        return hatch_fail(err, HATCH_BAD_INPUT, "line %u: element %.*s: %.*s is not a count", text->line,
                          hatch_mesh_text_shown(name), name.at, hatch_mesh_text_shown(number), number.at);
    memcpy(element->name, name.at, name.length);
    element->count = (uint64_t)count;
    element->kind = hatch_text_is(name, "vertex")      ? PLY_VERTEX
                    : hatch_text_is(name, "face")      ? PLY_FACE
                    : hatch_text_is(name, "tristrips") ? PLY_STRIPS
                                                       : PLY_OTHER;
    header->element_count++;
    return HATCH_OK;
}

static enum hatch_status read_property(struct hatch_mesh_text *text, struct ply_header *header, struct hatch_err *err)
{
    if (header->element_count == 0)
        return hatch_fail(err, HATCH_BAD_INPUT, "line %u: a property before any element", text->line);
    struct ply_element *element = &header->elements[header->element_count - 1];
    if (element->property_count == PLY_PROPERTIES_MAX)
        return hatch_fail(err, HATCH_BAD_INPUT, "line %u: more than %u properties", text->line, PLY_PROPERTIES_MAX);
    struct ply_property property = {PLY_NONE, PLY_NONE, PLY_SKIP};
    struct hatch_text word = hatch_mesh_text_word(text);
    bool list = hatch_text_is(word, "list");
    if (list) {
        property.count_type = type_of(hatch_mesh_text_word(text));
        word = hatch_mesh_text_word(text);
    }
    property.type = type_of(word);
    struct hatch_text name = hatch_mesh_text_word(text);
    bool integer_count = property.count_type != PLY_FLOAT32 && property.count_type != PLY_FLOAT64;
    if (property.type == PLY_NONE || (list && property.count_type == PLY_NONE) || !integer_count || name.length == 0)
        return hatch_fail(err, HATCH_BAD_INPUT, "line %u: property %.*s has an unknown type", text->line,
                          hatch_mesh_text_shown(name), name.at);
    property.use = use_of(element->kind, list, name);
    element->properties[element->property_count++] = property;
    return HATCH_OK;
}

static enum hatch_status read_line(struct hatch_mesh_text *text, struct ply_header *header, bool *format_seen,
                                   struct hatch_err *err)
{
    struct hatch_text word = hatch_mesh_text_word(text);
    if (hatch_text_is(word, "format")) {
        *format_seen = true;
        return read_format(text, header, err);
    }
    if (hatch_text_is(word, "element"))
        return read_element(text, header, err);
    if (hatch_text_is(word, "property"))
        return read_property(text, header, err);
    if (word.length == 0 || hatch_text_is(word, "comment") || hatch_text_is(word, "obj_info"))
        return HATCH_OK;
    return hatch_fail(err, HATCH_BAD_INPUT, "line %u: unknown keyword %.*s", text->line, hatch_mesh_text_shown(word),
                      word.at);
}

enum hatch_status hatch_ply_read_header(struct hatch_mesh_text *text, struct ply_header *header, struct hatch_err *err)
{
    bool format_seen = false;
    if (!hatch_text_is(hatch_mesh_text_word(text), "ply"))
        return hatch_fail(err, HATCH_BAD_INPUT, "does not start with ply");
    *header = (struct ply_header){.ascii = false};
    for (;;) {
        if (!hatch_mesh_text_next_line(text))
            return hatch_fail(err, HATCH_BAD_INPUT, "line %u: truncated before end_header", text->line);
        struct hatch_mesh_text ahead = *text;
        if (hatch_text_is(hatch_mesh_text_word(&ahead), "end_header"))
            break;
        HATCH_TRY(read_line(text, header, &format_seen, err));
    }
    hatch_mesh_text_next_line(text);
    if (!format_seen)
        return hatch_fail(err, HATCH_BAD_INPUT, "line %u: the header has no format", text->line);
    return HATCH_OK;
}
