#include <string.h>

#include "io/mesh/ply.h"

size_t hatch_ply_size(enum hatch_ply_type type)
{
    static const size_t sizes[] = {0, 1, 1, 2, 2, 4, 4, 4, 8};
    return sizes[type];
}

static enum hatch_ply_type type_of(struct hatch_text word)
{
    static const struct {
        const char *name;
        enum hatch_ply_type type;
    } names[] = {
        {"char", HATCH_PLY_INT8},       {"int8", HATCH_PLY_INT8},       {"uchar", HATCH_PLY_UINT8},
        {"uint8", HATCH_PLY_UINT8},     {"short", HATCH_PLY_INT16},     {"int16", HATCH_PLY_INT16},
        {"ushort", HATCH_PLY_UINT16},   {"uint16", HATCH_PLY_UINT16},   {"int", HATCH_PLY_INT32},
        {"int32", HATCH_PLY_INT32},     {"uint", HATCH_PLY_UINT32},     {"uint32", HATCH_PLY_UINT32},
        {"float", HATCH_PLY_FLOAT32},   {"float32", HATCH_PLY_FLOAT32}, {"double", HATCH_PLY_FLOAT64},
        {"float64", HATCH_PLY_FLOAT64},
    };
    for (size_t i = 0; i < sizeof names / sizeof *names; i++)
        if (hatch_text_is(word, names[i].name))
            return names[i].type;
    return HATCH_PLY_NONE;
}

static enum hatch_ply_use use_of(enum hatch_ply_kind kind, bool list, struct hatch_text word)
{
    static const struct {
        const char *name;
        enum hatch_ply_use use;
    } names[] = {
        {"x", HATCH_PLY_X},   {"y", HATCH_PLY_Y},   {"z", HATCH_PLY_Z},         {"nx", HATCH_PLY_NX},
        {"ny", HATCH_PLY_NY}, {"nz", HATCH_PLY_NZ}, {"u", HATCH_PLY_U},         {"v", HATCH_PLY_V},
        {"s", HATCH_PLY_U},   {"t", HATCH_PLY_V},   {"texture_u", HATCH_PLY_U}, {"texture_v", HATCH_PLY_V},
    };
    if ((kind == HATCH_PLY_FACE || kind == HATCH_PLY_STRIPS) && list)
        return hatch_text_is(word, "vertex_indices") || hatch_text_is(word, "vertex_index") ? HATCH_PLY_INDICES
                                                                                            : HATCH_PLY_SKIP;
    for (size_t i = 0; kind == HATCH_PLY_VERTEX && !list && i < sizeof names / sizeof *names; i++)
        if (hatch_text_is(word, names[i].name))
            return names[i].use;
    return HATCH_PLY_SKIP;
}

static enum hatch_status read_format(struct hatch_mesh_text *text, struct hatch_ply_header *header,
                                     struct hatch_err *err)
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

static enum hatch_status read_element(struct hatch_mesh_text *text, struct hatch_ply_header *header,
                                      struct hatch_err *err)
{
    if (header->element_count == HATCH_PLY_ELEMENTS_MAX)
        return hatch_fail(err, HATCH_BAD_INPUT, "line %u: more than %u elements", text->line, HATCH_PLY_ELEMENTS_MAX);
    struct hatch_text name = hatch_mesh_text_word(text), number = hatch_mesh_text_word(text);
    struct hatch_ply_element *element = &header->elements[header->element_count];
    int64_t count;
    if (name.length >= sizeof element->name || !hatch_mesh_text_integer(number, &count) || count < 0)
        return hatch_fail(err, HATCH_BAD_INPUT, "line %u: element %.*s: %.*s is not a count", text->line,
                          hatch_mesh_text_shown(name), name.at, hatch_mesh_text_shown(number), number.at);
    memcpy(element->name, name.at, name.length);
    element->count = (uint64_t)count;
    element->kind = hatch_text_is(name, "vertex")      ? HATCH_PLY_VERTEX
                    : hatch_text_is(name, "face")      ? HATCH_PLY_FACE
                    : hatch_text_is(name, "tristrips") ? HATCH_PLY_STRIPS
                                                       : HATCH_PLY_OTHER;
    header->element_count++;
    return HATCH_OK;
}

static enum hatch_status read_property(struct hatch_mesh_text *text, struct hatch_ply_header *header,
                                       struct hatch_err *err)
{
    if (header->element_count == 0)
        return hatch_fail(err, HATCH_BAD_INPUT, "line %u: a property before any element", text->line);
    struct hatch_ply_element *element = &header->elements[header->element_count - 1];
    if (element->property_count == HATCH_PLY_PROPERTIES_MAX)
        return hatch_fail(err, HATCH_BAD_INPUT, "line %u: more than %u properties", text->line,
                          HATCH_PLY_PROPERTIES_MAX);
    struct hatch_ply_property property = {HATCH_PLY_NONE, HATCH_PLY_NONE, HATCH_PLY_SKIP};
    struct hatch_text word = hatch_mesh_text_word(text);
    bool list = hatch_text_is(word, "list");
    if (list) {
        property.count_type = type_of(hatch_mesh_text_word(text));
        word = hatch_mesh_text_word(text);
    }
    property.type = type_of(word);
    struct hatch_text name = hatch_mesh_text_word(text);
    bool integer_count = property.count_type != HATCH_PLY_FLOAT32 && property.count_type != HATCH_PLY_FLOAT64;
    if (property.type == HATCH_PLY_NONE || (list && property.count_type == HATCH_PLY_NONE) || !integer_count ||
        name.length == 0)
        return hatch_fail(err, HATCH_BAD_INPUT, "line %u: property %.*s has an unknown type", text->line,
                          hatch_mesh_text_shown(name), name.at);
    property.use = use_of(element->kind, list, name);
    element->properties[element->property_count++] = property;
    return HATCH_OK;
}

static enum hatch_status read_line(struct hatch_mesh_text *text, struct hatch_ply_header *header, bool *format_seen,
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

enum hatch_status hatch_ply_read_header(struct hatch_mesh_text *text, struct hatch_ply_header *header,
                                        struct hatch_err *err)
{
    bool format_seen = false;
    if (!hatch_text_is(hatch_mesh_text_word(text), "ply"))
        return hatch_fail(err, HATCH_BAD_INPUT, "does not start with ply");
    *header = (struct hatch_ply_header){.ascii = false};
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
