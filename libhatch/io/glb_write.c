/* Meshes as binary glTF 2.0 (Khronos, "glTF 2.0 Specification", §4.4): one scene, node, mesh and
 * primitive; one buffer view per attribute. */
#include "io/gltf.h"

#include <assert.h>
#include <string.h>

enum { GLB_HEADER = 12, CHUNK_HEADER = 8 };
enum component_type { COMPONENT_U16 = 5123, COMPONENT_U32 = 5125, COMPONENT_F32 = 5126 };
enum view_target { TARGET_VERTICES = 34962, TARGET_INDICES = 34963 };

/* One accessor with the buffer view under it. */
struct accessor {
    enum component_type component;
    enum view_target target;
    uint32_t count, components;
    size_t offset, size; /* bytes in the buffer */
};

/* One per attribute, then the indices'. */
struct layout {
    struct accessor accessors[HATCH_MESH_ATTRIBUTES_MAX + 1];
    uint32_t count;
    size_t size;
};

static size_t padded(size_t size)
{
    return (size + 3) / 4 * 4;
}

static void add_accessor(struct layout *layout, struct accessor accessor)
{
    size_t component = accessor.component == COMPONENT_U16 ? 2 : 4;
    accessor.offset = layout->size;
    accessor.size = (size_t)accessor.count * accessor.components * component;
    layout->size += padded(accessor.size);
    layout->accessors[layout->count++] = accessor;
}

static struct layout plan(const struct hatch_mesh *mesh)
{
    struct layout layout = {.count = 0};
    for (uint32_t i = 0; i < mesh->attribute_count; i++) {
        bool joints = strncmp(mesh->attributes[i].name, "JOINTS_", 7) == 0;
        add_accessor(&layout, (struct accessor){
                                  .component = joints ? COMPONENT_U16 : COMPONENT_F32,
                                  .target = TARGET_VERTICES,
                                  .count = mesh->vertex_count,
                                  .components = mesh->attributes[i].components,
                              });
    }
    /* The largest value of a type means primitive restart and is no index. */
    bool narrow = mesh->vertex_count <= UINT16_MAX;
    add_accessor(&layout, (struct accessor){
                              .component = narrow ? COMPONENT_U16 : COMPONENT_U32,
                              .target = TARGET_INDICES,
                              .count = mesh->face_count * 3,
                              .components = 1,
                          });
    return layout;
}

/* A JSON string; what is not plain ASCII becomes a question mark. */
static enum hatch_status print_text(struct hatch_buffer *json, const char *text,
                                    struct hatch_err *err)
{
    HATCH_TRY(hatch_buffer_add(json, "\"", 1, err));
    for (; *text; text++) {
        if (*text == '"' || *text == '\\')
            HATCH_TRY(hatch_buffer_add(json, "\\", 1, err));
        HATCH_TRY(hatch_buffer_add(json, *text >= 0x20 && *text < 0x7f ? text : "?", 1, err));
    }
    return hatch_buffer_add(json, "\"", 1, err);
}

static enum hatch_status print_head(const struct hatch_mesh *mesh, const char *name,
                                    const char *comment, struct hatch_buffer *json,
                                    struct hatch_err *err)
{
    HATCH_TRY(hatch_buffer_print(json, err, "{\"asset\":{\"version\":\"2.0\",\"generator\":\"hatch\""));
    if (comment) {
        HATCH_TRY(hatch_buffer_print(json, err, ",\"extras\":{\"hatch\":"));
        HATCH_TRY(print_text(json, comment, err));
        HATCH_TRY(hatch_buffer_print(json, err, "}"));
    }
    HATCH_TRY(hatch_buffer_print(json, err,
                                 "},\"scene\":0,\"scenes\":[{\"nodes\":[0]}],"
                                 "\"nodes\":[{\"mesh\":0,\"name\":"));
    HATCH_TRY(print_text(json, name, err));
    HATCH_TRY(hatch_buffer_print(json, err, "}],\"meshes\":[{\"name\":"));
    HATCH_TRY(print_text(json, name, err));
    HATCH_TRY(hatch_buffer_print(json, err, ",\"primitives\":[{\"attributes\":{"));
    for (uint32_t i = 0; i < mesh->attribute_count; i++)
        HATCH_TRY(hatch_buffer_print(json, err, "%s\"%s\":%u", i ? "," : "",
                                     mesh->attributes[i].name, i));
    return hatch_buffer_print(json, err, "},\"indices\":%u,\"mode\":4}]}]", mesh->attribute_count);
}

/* The box around all vertices, which the format requires of POSITION. */
static enum hatch_status print_bounds(const struct hatch_mesh *mesh, struct hatch_buffer *json,
                                      struct hatch_err *err)
{
    const float *p = mesh->attributes[0].data;
    float low[3] = {p[0], p[1], p[2]}, high[3] = {p[0], p[1], p[2]};
    for (size_t i = 3; i < (size_t)mesh->vertex_count * 3; i++) {
        if (p[i] < low[i % 3])
            low[i % 3] = p[i];
        if (p[i] > high[i % 3])
            high[i % 3] = p[i];
    }
    /* Nine digits name a float exactly. */
    return hatch_buffer_print(json, err, ",\"min\":[%.9g,%.9g,%.9g],\"max\":[%.9g,%.9g,%.9g]",
                              (double)low[0], (double)low[1], (double)low[2], (double)high[0],
                              (double)high[1], (double)high[2]);
}

static enum hatch_status print_accessors(const struct hatch_mesh *mesh, const struct layout *layout,
                                         struct hatch_buffer *json, struct hatch_err *err)
{
    static const char *const types[] = {"SCALAR", "VEC2", "VEC3", "VEC4"};
    HATCH_TRY(hatch_buffer_print(json, err, ",\"accessors\":["));
    for (uint32_t i = 0; i < layout->count; i++) {
        const struct accessor *a = &layout->accessors[i];
        HATCH_TRY(hatch_buffer_print(
            json, err, "%s{\"bufferView\":%u,\"componentType\":%d,\"count\":%u,\"type\":\"%s\"",
            i ? "," : "", i, (int)a->component, a->count, types[a->components - 1]));
        if (i == 0)
            HATCH_TRY(print_bounds(mesh, json, err));
        HATCH_TRY(hatch_buffer_print(json, err, "}"));
    }
    HATCH_TRY(hatch_buffer_print(json, err, "],\"bufferViews\":["));
    for (uint32_t i = 0; i < layout->count; i++) {
        const struct accessor *a = &layout->accessors[i];
        HATCH_TRY(hatch_buffer_print(
            json, err, "%s{\"buffer\":0,\"byteOffset\":%zu,\"byteLength\":%zu,\"target\":%d}",
            i ? "," : "", a->offset, a->size, (int)a->target));
    }
    return hatch_buffer_print(json, err, "],\"buffers\":[{\"byteLength\":%zu}]}", layout->size);
}

static enum hatch_status print_json(const struct hatch_mesh *mesh, const struct layout *layout,
                                    const char *name, const char *comment,
                                    struct hatch_buffer *json, struct hatch_err *err)
{
    HATCH_TRY(print_head(mesh, name, comment, json, err));
    HATCH_TRY(print_accessors(mesh, layout, json, err));
    while (json->size % 4)
        HATCH_TRY(hatch_buffer_add(json, " ", 1, err));
    return HATCH_OK;
}

static void put_u16(uint8_t *at, uint32_t value)
{
    at[0] = (uint8_t)value;
    at[1] = (uint8_t)(value >> 8);
}

static void put_u32(uint8_t *at, uint32_t value)
{
    put_u16(at, value);
    put_u16(at + 2, value >> 16);
}

static void put_floats(uint8_t *at, const float *values, size_t count, bool as_u16)
{
    for (size_t i = 0; i < count; i++) {
        uint32_t bits;
        memcpy(&bits, &values[i], sizeof bits);
        if (as_u16)
            put_u16(at + 2 * i, (uint32_t)values[i]);
        else
            put_u32(at + 4 * i, bits);
    }
}

static void put_buffer(const struct hatch_mesh *mesh, const struct layout *layout, uint8_t *at)
{
    for (uint32_t i = 0; i < mesh->attribute_count; i++) {
        const struct accessor *a = &layout->accessors[i];
        put_floats(at + a->offset, mesh->attributes[i].data, (size_t)a->count * a->components,
                   a->component == COMPONENT_U16);
    }
    const struct accessor *a = &layout->accessors[layout->count - 1];
    for (size_t i = 0; i < a->count; i++)
        if (a->component == COMPONENT_U16)
            put_u16(at + a->offset + 2 * i, mesh->indices[i]);
        else
            put_u32(at + a->offset + 4 * i, mesh->indices[i]);
}

static enum hatch_status write_chunks(const struct hatch_mesh *mesh, const struct layout *layout,
                                      const struct hatch_buffer *json, struct hatch_buffer *file,
                                      struct hatch_err *err)
{
    size_t whole = GLB_HEADER + 2 * CHUNK_HEADER + json->size + layout->size;
    if (whole > UINT32_MAX)
        return hatch_fail(err, HATCH_LIMIT, "%zu bytes: a GLB file holds at most %u", whole,
                          UINT32_MAX);
    HATCH_TRY(hatch_buffer_reserve(file, whole, err));
    HATCH_TRY(hatch_buffer_add(file, "glTF", 4, err));
    HATCH_TRY(hatch_buffer_add_u32le(file, 2, err));
    HATCH_TRY(hatch_buffer_add_u32le(file, (uint32_t)whole, err));
    HATCH_TRY(hatch_buffer_add_u32le(file, (uint32_t)json->size, err));
    HATCH_TRY(hatch_buffer_add(file, "JSON", 4, err));
    HATCH_TRY(hatch_buffer_add(file, json->data, json->size, err));
    HATCH_TRY(hatch_buffer_add_u32le(file, (uint32_t)layout->size, err));
    HATCH_TRY(hatch_buffer_add(file, "BIN", 4, err));
    HATCH_TRY(hatch_buffer_add(file, NULL, layout->size, err));
    put_buffer(mesh, layout, file->data + file->size - layout->size);
    return HATCH_OK;
}

enum hatch_status hatch_glb_write(const struct hatch_mesh *mesh, const char *name, const char *comment,
                                  struct hatch_arena *scratch, struct hatch_buffer *file,
                                  struct hatch_err *err)
{
    assert(mesh->face_count > 0 && mesh->vertex_count > 0);
    assert(mesh->face_count <= UINT32_MAX / 3);
    struct hatch_arena_mark mark = hatch_arena_mark(scratch);
    struct layout layout = plan(mesh);
    struct hatch_buffer json = {.arena = scratch};
    enum hatch_status status = print_json(mesh, &layout, name, comment, &json, err);
    if (status == HATCH_OK)
        status = write_chunks(mesh, &layout, &json, file, err);
    hatch_arena_rewind(scratch, mark);
    return status;
}
