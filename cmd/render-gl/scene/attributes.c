#include "render-gl/scene/attributes.h"

#include <math.h>
#include <stddef.h>

#include "base/random.h"
#include "mesh/fans.h"
#include "mesh/uv_tangents.h"
#include "render-gl/gpu/bindings.h"
#include "render-gl/gpu/buffer.h"
#include "scene/uv_charts.h"

static void upload_repeats(const struct scene *scene, uint32_t index)
{
    static const struct gpu_attribute attribute = {ATTRIBUTE_REPEAT, 2, GL_FLOAT, 0};
    const struct hatch_item *unit = &scene->unit.items[index];
    struct scene_item *item = &scene->items[index];
    size_t stride = 2 * sizeof *unit->repeats;
    glDeleteBuffers(1, &item->repeats);
    item->repeats = 0;
    glDisableVertexArrayAttrib(item->vertex_array, ATTRIBUTE_REPEAT);
    if (!unit->repeats)
        return;
    item->repeats = gpu_buffer_make(unit->repeats, stride * scene->unit.meshes[unit->mesh].mesh->vertex_count);
    gpu_array_attach(item->vertex_array, SCENE_SLOT_REPEATS, item->repeats, stride, &attribute, 1);
}

enum hatch_status scene_set_repeats(struct scene *scene, const struct hatch_uv_repeat *how, struct hatch_arena *arena,
                                    struct hatch_arena *scratch, struct hatch_err *err)
{
    HATCH_TRY(hatch_uv_repeat_set(&scene->unit, how, arena, scratch, err));
    for (uint32_t i = 0; i < scene->unit.item_count; i++)
        upload_repeats(scene, i);
    return HATCH_OK;
}

/* Exchanges the repeats in use and the others. */
static void exchange_repeats(struct scene *scene)
{
    for (uint32_t i = 0; i < scene->unit.item_count; i++) {
        struct hatch_item *item = &scene->unit.items[i];
        const struct scene_repeats used = {{item->repeat[0], item->repeat[1]}, item->repeats, item->chart_count};
        item->repeat[0] = scene->others[i].repeat[0];
        item->repeat[1] = scene->others[i].repeat[1];
        item->repeats = scene->others[i].repeats;
        item->chart_count = scene->others[i].chart_count;
        scene->others[i] = used;
        upload_repeats(scene, i);
    }
    scene->replaced = !scene->replaced;
}

enum hatch_status scene_replace_repeats(struct scene *scene, const struct hatch_uv_repeat *how,
                                        struct hatch_arena *arena, struct hatch_arena *scratch, struct hatch_err *err)
{
    if (scene->replaced)
        return HATCH_OK;
    bool known = scene->others != NULL;
    if (!known)
        HATCH_TRY(HATCH_ALLOC(arena, &scene->others, scene->unit.item_count, err));
    exchange_repeats(scene);
    return known ? HATCH_OK : scene_set_repeats(scene, how, arena, scratch, err);
}

void scene_restore_repeats(struct scene *scene)
{
    if (scene->replaced)
        exchange_repeats(scene);
}

static enum hatch_status set_uv_tangents(struct scene *scene, uint32_t index, struct hatch_arena *scratch,
                                         struct hatch_err *err)
{
    static const struct gpu_attribute attributes[] = {{ATTRIBUTE_ALONG_U, 3, GL_FLOAT, 0},
                                                      {ATTRIBUTE_ALONG_V, 3, GL_FLOAT, 3 * sizeof(float)}};
    struct hatch_item *unit = &scene->unit.items[index];
    struct scene_item *item = &scene->items[index];
    const struct hatch_mesh *mesh = scene->unit.meshes[unit->mesh].mesh;
    size_t stride = 6 * sizeof(float);
    float *tangents;
    if (!hatch_mesh_find(mesh, "TEXCOORD_0", 2))
        return HATCH_OK;
    if (!(unit->uv_reach > 0))
        unit->uv_reach = hatch_uv_reach(mesh);
    if (unit->deformed || item->uv_tangents)
        return HATCH_OK;
    HATCH_TRY(hatch_uv_tangents(mesh, scratch, &tangents, err));
    item->uv_tangents = gpu_buffer_make(tangents, stride * mesh->vertex_count);
    gpu_array_attach(item->vertex_array, SCENE_SLOT_UV_TANGENTS, item->uv_tangents, stride, attributes, 2);
    return HATCH_OK;
}

enum hatch_status scene_set_uv_tangents(struct scene *scene, struct hatch_arena *scratch, struct hatch_err *err)
{
    for (uint32_t i = 0; i < scene->unit.item_count; i++) {
        struct hatch_arena_mark mark = hatch_arena_mark(scratch);
        enum hatch_status status = set_uv_tangents(scene, i, scratch, err);
        hatch_arena_rewind(scratch, mark);
        HATCH_TRY(status);
    }
    return HATCH_OK;
}

void scene_set_rest(struct scene *scene)
{
    static const struct gpu_attribute attribute = {ATTRIBUTE_REST, 3, GL_FLOAT,
                                                   offsetof(struct scene_vertex, position)};
    for (uint32_t i = 0; i < scene->unit.item_count; i++) {
        const struct scene_item *item = &scene->items[i];
        GLuint vertices = scene->meshes[scene->unit.items[i].mesh].vertices;
        const GLuint arrays[] = {item->vertex_array, item->surface_array};
        for (int k = 0; k < 2 && arrays[k]; k++)
            gpu_array_attach(arrays[k], SCENE_SLOT_REST, vertices, sizeof(struct scene_vertex), &attribute, 1);
    }
}

static enum hatch_status make_patch_tones(const struct hatch_patch_mesh *patches, struct hatch_arena *scratch,
                                          struct scene_mesh *mesh, struct hatch_err *err)
{
    struct hatch_arena_mark mark = hatch_arena_mark(scratch);
    uint32_t count = patches->first_vertex[patches->patch_count];
    float *tones = HATCH_NEW(scratch, float, count, err);
    if (!tones)
        return HATCH_LIMIT;
    for (uint32_t patch = 0; patch < patches->patch_count; patch++)
        for (uint32_t v = patches->first_vertex[patch]; v < patches->first_vertex[patch + 1]; v++)
            tones[v] = 1.0f - powf(0.3f + 0.7f * hatch_random_unit(1, 0, patch), 2.2f); /* perceptually uniform */
    mesh->patch_tones = gpu_buffer_make(tones, sizeof *tones * count);
    hatch_arena_rewind(scratch, mark);
    return HATCH_OK;
}

enum hatch_status scene_set_patch_tones(struct scene *scene, struct hatch_arena *scratch, struct hatch_err *err)
{
    static const struct gpu_attribute attribute = {ATTRIBUTE_PATCH, 1, GL_FLOAT, 0};
    for (uint32_t i = 0; i < scene->unit.item_count; i++) {
        const struct hatch_patch_mesh *patches = scene->unit.meshes[scene->unit.items[i].mesh].patches;
        struct scene_mesh *mesh = &scene->meshes[scene->unit.items[i].mesh];
        if (!patches)
            continue;
        if (!mesh->patch_tones)
            HATCH_TRY(make_patch_tones(patches, scratch, mesh, err));
        gpu_array_attach(scene->items[i].vertex_array, SCENE_SLOT_PATCHES, mesh->patch_tones, sizeof(float), &attribute,
                         1);
    }
    return HATCH_OK;
}

static enum hatch_status make_charts(const struct hatch_unit_mesh *unit, struct hatch_arena *scratch,
                                     struct scene_mesh *mesh, struct hatch_err *err)
{
    const float *texcoord = hatch_mesh_find(unit->mesh, "TEXCOORD_0", 2);
    const uint32_t count = unit->mesh->vertex_count;
    struct hatch_arena_mark mark = hatch_arena_mark(scratch);
    uint32_t *charts;
    if (!texcoord || mesh->charts)
        return HATCH_OK;
    HATCH_TRY(HATCH_ALLOC_UNSET(scratch, &charts, count, err));
    if (!unit->patches)
        HATCH_TRY(hatch_uv_charts_join(unit->mesh, texcoord, scratch, charts, err));
    for (uint32_t v = 0; !unit->patches && v < count; v++)
        charts[v] = hatch_sets_find(charts, v);
    for (uint32_t patch = 0; unit->patches && patch < unit->patches->patch_count; patch++)
        for (uint32_t v = unit->patches->first_vertex[patch]; v < unit->patches->first_vertex[patch + 1]; v++)
            charts[v] = patch;
    mesh->charts = gpu_buffer_make(charts, sizeof *charts * count);
    hatch_arena_rewind(scratch, mark);
    return HATCH_OK;
}

enum hatch_status scene_set_charts(struct scene *scene, struct hatch_arena *scratch, struct hatch_err *err)
{
    static const struct gpu_attribute attribute = {ATTRIBUTE_CHART, 1, GL_UNSIGNED_INT, 0};
    for (uint32_t i = 0; i < scene->unit.item_count; i++) {
        const uint32_t index = scene->unit.items[i].mesh;
        struct scene_mesh *mesh = &scene->meshes[index];
        HATCH_TRY(make_charts(&scene->unit.meshes[index], scratch, mesh, err));
        if (mesh->charts)
            gpu_array_attach(scene->items[i].vertex_array, SCENE_SLOT_CHARTS, mesh->charts, sizeof(uint32_t),
                             &attribute, 1);
    }
    return HATCH_OK;
}
