#include "render-gl/scene/scene.h"

#include <math.h>
#include <stddef.h>

#include "render-gl/gpu/bindings.h"
#include "render-gl/gpu/buffer.h"

void scene_place_texcoord(const struct hatch_texture_use *use, float at[2])
{
    if (!use->has_transform)
        return;
    double c = cos((double)use->turn_rad), s = sin((double)use->turn_rad);
    double u = (double)use->scale[0] * (double)at[0], v = (double)use->scale[1] * (double)at[1];
    at[0] = (float)(c * u + s * v + (double)use->offset[0]);
    at[1] = (float)(c * v - s * u + (double)use->offset[1]);
}

const float *scene_texcoords(const struct hatch_mesh *mesh, uint32_t set)
{
    char name[] = "TEXCOORD_n";
    name[9] = (char)('0' + set);
    return hatch_mesh_find(mesh, name, 2);
}

enum hatch_status scene_make_vertices(const struct hatch_scene *scene, uint32_t index, const double origin[3],
                                      struct hatch_arena *arena, struct scene_vertex **vertices, struct hatch_err *err)
{
    const struct hatch_scene_mesh *from = &scene->meshes[index];
    const struct hatch_mesh *mesh = &from->mesh;
    const struct hatch_material *material = from->material != HATCH_NONE ? &scene->materials[from->material] : NULL;
    uint32_t set = !material ? 0 : material->outline ? 1 : material->base.texcoord;
    const float *position = hatch_mesh_find(mesh, "POSITION", 3), *normal = hatch_mesh_find(mesh, "NORMAL", 3);
    const float *texcoord = hatch_mesh_find(mesh, "TEXCOORD_0", 2), *base = scene_texcoords(mesh, set);
    struct scene_vertex *made = HATCH_NEW(arena, struct scene_vertex, mesh->vertex_count, err);
    if (!made)
        return HATCH_LIMIT;
    for (size_t v = 0; v < mesh->vertex_count; v++) {
        for (size_t k = 0; k < 3; k++) {
            made[v].position[k] = (float)((double)position[3 * v + k] - origin[k]);
            made[v].normal[k] = normal ? normal[3 * v + k] : 0.0f;
        }
        for (size_t k = 0; k < 2; k++) {
            made[v].texcoord[k] = texcoord ? texcoord[2 * v + k] : 0.0f;
            made[v].base_texcoord[k] = base ? base[2 * v + k] : 0.0f;
        }
        if (material)
            scene_place_texcoord(&material->base, made[v].base_texcoord);
    }
    *vertices = made;
    return HATCH_OK;
}

/* Uploads indices of the surface below patches. It uses the vertices of the patches. */
static enum hatch_status upload_surface(const struct hatch_unit_mesh *unit, struct hatch_arena *scratch,
                                        struct scene_mesh *mesh, struct hatch_err *err)
{
    size_t count = 3 * (size_t)unit->surface->face_count;
    uint32_t *indices = HATCH_NEW(scratch, uint32_t, count, err);
    if (!indices)
        return HATCH_LIMIT;
    for (size_t i = 0; i < count; i++)
        indices[i] = unit->patches->vertex_of[unit->surface->indices[i]];
    mesh->surface_indices = gpu_buffer_make(indices, sizeof *indices * count);
    return HATCH_OK;
}

static enum hatch_status upload_mesh(const struct hatch_unit_scene *unit, uint32_t index, struct hatch_arena *scratch,
                                     struct scene_mesh *mesh, struct hatch_err *err)
{
    const struct hatch_unit_mesh *from = &unit->meshes[index];
    struct hatch_arena_mark mark = hatch_arena_mark(scratch);
    struct scene_vertex *vertices;
    HATCH_TRY(scene_make_vertices(unit->scene, index, from->origin, scratch, &vertices, err));
    mesh->index_count = 3 * from->mesh->face_count;
    mesh->vertices = gpu_buffer_make(vertices, sizeof *vertices * from->mesh->vertex_count);
    mesh->indices = gpu_buffer_make(from->mesh->indices, sizeof(uint32_t) * mesh->index_count);
    if (from->patches)
        HATCH_TRY(upload_surface(from, scratch, mesh, err));
    hatch_arena_rewind(scratch, mark);
    return gpu_check_memory(err, "mesh %u", index);
}

static GLuint make_vertex_array(GLuint vertices, GLuint indices)
{
    static const struct gpu_attribute attributes[] = {
        {ATTRIBUTE_POSITION, 3, GL_FLOAT, offsetof(struct scene_vertex, position)},
        {ATTRIBUTE_NORMAL, 3, GL_FLOAT, offsetof(struct scene_vertex, normal)},
        {ATTRIBUTE_TEXCOORD, 2, GL_FLOAT, offsetof(struct scene_vertex, texcoord)},
        {ATTRIBUTE_BASE_TEXCOORD, 2, GL_FLOAT, offsetof(struct scene_vertex, base_texcoord)}};
    GLuint array;
    glCreateVertexArrays(1, &array);
    glVertexArrayElementBuffer(array, indices);
    gpu_array_attach(array, SCENE_SLOT_VERTICES, vertices, sizeof(struct scene_vertex), attributes,
                     sizeof attributes / sizeof *attributes);
    return array;
}

static void make_item(const struct scene *scene, uint32_t index, struct scene_item *item)
{
    const struct hatch_item *unit = &scene->unit.items[index];
    const struct scene_mesh *mesh = &scene->meshes[unit->mesh];
    *item = (struct scene_item){.base_color = {1, 1, 1}, .base_lightness = 1.0f};
    if (unit->deformed)
        item->posed =
            gpu_buffer_make(NULL, sizeof(struct scene_vertex) * scene->unit.meshes[unit->mesh].mesh->vertex_count);
    GLuint vertices = unit->deformed ? item->posed : mesh->vertices;
    item->vertex_array = make_vertex_array(vertices, mesh->indices);
    if (mesh->surface_indices)
        item->surface_array = make_vertex_array(vertices, mesh->surface_indices);
}

enum hatch_status scene_upload(const struct hatch_scene *from, const struct hatch_patch_mesh *patches,
                               const struct hatch_bounds *bounds, struct hatch_arena *arena,
                               struct hatch_arena *scratch, struct scene *scene, struct hatch_err *err)
{
    struct scene made = {.replaced = false};
    HATCH_TRY(hatch_unit_scene_make(from, patches, bounds, arena, &made.unit, err));
    made.meshes = HATCH_NEW(arena, struct scene_mesh, from->mesh_count, err);
    made.items = made.meshes ? HATCH_NEW(arena, struct scene_item, made.unit.item_count, err) : NULL;
    if (!made.items)
        return HATCH_LIMIT;
    for (uint32_t i = 0; i < from->mesh_count; i++)
        HATCH_TRY(upload_mesh(&made.unit, i, scratch, &made.meshes[i], err));
    for (uint32_t i = 0; i < made.unit.item_count; i++)
        make_item(&made, i, &made.items[i]);
    *scene = made;
    return HATCH_OK;
}

void scene_free(struct scene *scene)
{
    for (uint32_t i = 0; i < scene->unit.item_count; i++) {
        const struct scene_item *item = &scene->items[i];
        const GLuint arrays[] = {item->vertex_array, item->surface_array};
        const GLuint buffers[] = {item->posed, item->repeats, item->uv_tangents, item->tangents};
        const GLuint textures[] = {item->base_texture, item->normals};
        glDeleteVertexArrays(2, arrays);
        glDeleteBuffers(4, buffers);
        glDeleteTextures(2, textures);
    }
    for (uint32_t i = 0; scene->meshes && i < scene->unit.scene->mesh_count; i++) {
        const struct scene_mesh *mesh = &scene->meshes[i];
        const GLuint buffers[] = {mesh->vertices, mesh->indices, mesh->surface_indices, mesh->patch_tones,
                                  mesh->charts};
        glDeleteBuffers(5, buffers);
    }
    *scene = (struct scene){.meshes = NULL};
}
