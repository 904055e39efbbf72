#include "mesh/remap.h"

#include <string.h>

#include "base/keys.h"

/* Numbers the different vertices: those that are one point and equal in values get the same number.
 *   point   per vertex; NULL: by position
 *   values  3 per vertex */
static enum hatch_status number_vertices(const struct hatch_mesh *mesh, const uint32_t *point, float *values,
                                         struct hatch_arena *scratch, struct hatch_remap *remap, struct hatch_err *err)
{
    uint32_t *welded, *value, unused;
    HATCH_TRY(HATCH_ALLOC(scratch, &welded, mesh->vertex_count, err));
    HATCH_TRY(HATCH_ALLOC(scratch, &value, mesh->vertex_count, err));
    struct hatch_mesh others = {.vertex_count = mesh->vertex_count, .attribute_count = 1};
    others.attributes[0].data = values;
    if (!point)
        HATCH_TRY(hatch_mesh_weld(mesh, scratch, welded, &unused, err));
    HATCH_TRY(hatch_mesh_weld(&others, scratch, value, &unused, err));
    struct hatch_keys keys;
    HATCH_TRY(hatch_keys_make(scratch, &keys, err));
    for (uint32_t v = 0; v < mesh->vertex_count; v++) {
        uint64_t key = (uint64_t)(point ? point : welded)[v] << 32 | value[v];
        HATCH_TRY(hatch_keys_number(&keys, key, &remap->number[v], err));
        if (keys.count > remap->count)
            remap->first[remap->count++] = v;
    }
    return HATCH_OK;
}

enum hatch_status hatch_remap_by_values(const struct hatch_mesh *mesh, const uint32_t *point, float *values,
                                        struct hatch_arena *arena, struct hatch_arena *scratch,
                                        struct hatch_remap *remap, struct hatch_err *err)
{
    struct hatch_remap made = {0};
    HATCH_TRY(HATCH_ALLOC(arena, &made.number, mesh->vertex_count, err));
    HATCH_TRY(HATCH_ALLOC(arena, &made.first, mesh->vertex_count, err));
    struct hatch_arena_mark mark = hatch_arena_mark(scratch);
    enum hatch_status status = number_vertices(mesh, point, values, scratch, &made, err);
    hatch_arena_rewind(scratch, mark);
    if (status == HATCH_OK)
        *remap = made;
    return status;
}

enum hatch_status hatch_remap_weld(const struct hatch_mesh *mesh, float *values, struct hatch_arena *scratch,
                                   uint32_t *vertex_to_point, uint32_t *point_count, struct hatch_err *err)
{
    struct hatch_remap remap = {.count = 0};
    struct hatch_arena_mark mark = hatch_arena_mark(scratch);
    enum hatch_status status = hatch_remap_by_values(mesh, NULL, values, scratch, scratch, &remap, err);
    for (uint32_t v = 0; v < mesh->vertex_count && status == HATCH_OK; v++)
        vertex_to_point[v] = remap.number[v];
    *point_count = remap.count;
    hatch_arena_rewind(scratch, mark);
    return status;
}

enum hatch_status hatch_remap_by_texcoord(const struct hatch_mesh *mesh, struct hatch_arena *arena,
                                          struct hatch_remap *remap, struct hatch_err *err)
{
    const float *texcoord = hatch_mesh_find(mesh, "TEXCOORD_0", 2);
    float *values;
    HATCH_TRY(HATCH_ALLOC(arena, &values, 3 * (size_t)mesh->vertex_count, err));
    for (size_t v = 0; v < mesh->vertex_count; v++)
        memcpy(values + 3 * v, texcoord + 2 * v, 2 * sizeof *values);
    return hatch_remap_by_values(mesh, NULL, values, arena, arena, remap, err);
}

enum hatch_status hatch_remap_attributes(const struct hatch_mesh *from, const uint32_t *origin_of,
                                         struct hatch_arena *arena, struct hatch_mesh *to, struct hatch_err *err)
{
    for (uint32_t i = 0; i < from->attribute_count; i++) {
        const struct hatch_mesh_attribute *other = &from->attributes[i];
        size_t n = other->components;
        float *data = to->attributes[0].data;
        if (strncmp(other->name, "TEXCOORD_", 9) == 0)
            continue;
        if (i > 0)
            HATCH_TRY(hatch_mesh_add(arena, to, other->name, other->components, &data, err));
        for (size_t v = 0; v < to->vertex_count; v++)
            memcpy(&data[n * v], &other->data[n * origin_of[v]], n * sizeof *data);
    }
    return HATCH_OK;
}
