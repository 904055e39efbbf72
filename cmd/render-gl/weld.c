#include "render-gl/weld.h"

#include <string.h>

#include "render-gl/lines_keys.h"

static enum hatch_status number(const struct hatch_mesh *mesh, struct hatch_arena *scratch,
                                struct weld *weld, struct hatch_err *err)
{
    uint32_t *point = HATCH_NEW(scratch, uint32_t, mesh->vertex_count, err);
    uint32_t *normal = point ? HATCH_NEW(scratch, uint32_t, mesh->vertex_count, err) : NULL, unused;
    if (!normal)
        return HATCH_LIMIT;
    struct hatch_mesh normals = {.vertex_count = mesh->vertex_count, .attribute_count = 1};
    normals.attributes[0].data = hatch_mesh_find(mesh, "NORMAL", 3);
    HATCH_TRY(hatch_mesh_weld(mesh, scratch, point, &unused, err));
    HATCH_TRY(hatch_mesh_weld(&normals, scratch, normal, &unused, err));
    struct line_keys keys;
    HATCH_TRY(line_keys_make(scratch, &keys, err));
    for (uint32_t v = 0; v < mesh->vertex_count; v++) {
        uint64_t key = (uint64_t)point[v] << 32 | normal[v];
        HATCH_TRY(line_keys_number(&keys, key, &weld->number[v], err));
        if (keys.count > weld->count)
            weld->first[weld->count++] = v;
    }
    return HATCH_OK;
}

enum hatch_status weld_vertices(const struct hatch_mesh *mesh, struct hatch_arena *arena,
                                struct hatch_arena *scratch, struct weld *weld,
                                struct hatch_err *err)
{
    struct weld made = {.number = HATCH_NEW(arena, uint32_t, mesh->vertex_count, err)};
    made.first = made.number ? HATCH_NEW(arena, uint32_t, mesh->vertex_count, err) : NULL;
    if (!made.first)
        return HATCH_LIMIT;
    struct hatch_arena_mark mark = hatch_arena_mark(scratch);
    enum hatch_status status = number(mesh, scratch, &made, err);
    hatch_arena_rewind(scratch, mark);
    if (status == HATCH_OK)
        *weld = made;
    return status;
}

enum hatch_status weld_take(const struct hatch_mesh *from, const uint32_t *origin_of,
                            struct hatch_arena *arena, struct hatch_mesh *to,
                            struct hatch_err *err)
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
