#include "render-gl/scene.h"

#include <math.h>
#include <stddef.h>
#include <string.h>

#include "base/random.h"
#include "render-gl/normals.h"

static void find_middle(const struct hatch_mesh *mesh, double middle[3], double half[3])
{
    float low[3], high[3];
    bool any = hatch_mesh_bounds(mesh, low, high);
    for (int k = 0; k < 3; k++) {
        middle[k] = any ? 0.5 * (double)low[k] + 0.5 * (double)high[k] : 0.0;
        half[k] = any ? 0.5 * (double)high[k] - 0.5 * (double)low[k] : 0.0;
    }
}

/* Where a material's texture is read: scaled, turned, moved (KHR_texture_transform). */
void scene_place(const float scale[2], float turn_rad, const float offset[2], float at[2])
{
    double c = cos((double)turn_rad), s = sin((double)turn_rad);
    double u = (double)scale[0] * (double)at[0], v = (double)scale[1] * (double)at[1];
    at[0] = (float)(c * u + s * v + (double)offset[0]);
    at[1] = (float)(c * v - s * u + (double)offset[1]);
}

const float *scene_texcoords(const struct hatch_mesh *mesh, uint32_t set)
{
    char name[] = "TEXCOORD_n";
    name[9] = (char)('0' + set);
    return hatch_mesh_find(mesh, name, 2);
}

static struct vertex *make_vertices(const struct hatch_scene *scene, uint32_t index, const double origin[3],
                                    struct hatch_arena *arena, struct hatch_err *err)
{
    const struct hatch_scene_mesh *from = &scene->meshes[index];
    const struct hatch_mesh *mesh = &from->mesh;
    const struct hatch_material *material = from->material != HATCH_NONE ? &scene->materials[from->material] : NULL;
    uint32_t set = !material ? 0 : material->outline ? 1 : material->base.texcoord;
    const float *position = hatch_mesh_find(mesh, "POSITION", 3);
    const float *normal = hatch_mesh_find(mesh, "NORMAL", 3);
    const float *texcoord = hatch_mesh_find(mesh, "TEXCOORD_0", 2);
    const float *base = scene_texcoords(mesh, set);
    struct vertex *vertices = HATCH_NEW(arena, struct vertex, mesh->vertex_count, err);
    for (size_t v = 0; vertices && v < mesh->vertex_count; v++) {
        for (size_t k = 0; k < 3; k++) {
            vertices[v].position[k] = (float)((double)position[3 * v + k] - origin[k]);
            vertices[v].normal[k] = normal ? normal[3 * v + k] : 0.0f;
        }
        for (size_t k = 0; k < 2; k++) {
            vertices[v].texcoord[k] = texcoord ? texcoord[2 * v + k] : 0.0f;
            vertices[v].base_texcoord[k] = base ? base[2 * v + k] : 0.0f;
        }
        if (material && material->base.placed)
            scene_place(material->base.scale, material->base.turn_rad, material->base.offset,
                        vertices[v].base_texcoord);
    }
    return vertices;
}

/* The surface below patches shares their vertices. */
static enum hatch_status upload_surface(struct gpu_mesh *gpu, struct hatch_arena *scratch, struct hatch_err *err)
{
    size_t count = 3 * (size_t)gpu->surface->face_count;
    uint32_t *indices = HATCH_NEW(scratch, uint32_t, count, err);
    if (!indices)
        return HATCH_LIMIT;
    for (size_t i = 0; i < count; i++)
        indices[i] = gpu->patches->vertex_of[gpu->surface->indices[i]];
    glCreateBuffers(1, &gpu->surface_indices);
    glNamedBufferStorage(gpu->surface_indices, (GLsizeiptr)(sizeof *indices * (count + 1)), NULL,
                         GL_DYNAMIC_STORAGE_BIT);
    glNamedBufferSubData(gpu->surface_indices, 0, (GLsizeiptr)(sizeof *indices * count), indices);
    return HATCH_OK;
}

static enum hatch_status upload_mesh(const struct hatch_scene *scene, uint32_t index, struct hatch_arena *scratch,
                                     struct gpu_mesh *gpu, struct hatch_err *err)
{
    const struct hatch_mesh *mesh = &scene->meshes[index].mesh;
    struct hatch_arena_mark mark = hatch_arena_mark(scratch);
    find_middle(mesh, gpu->origin, gpu->half);
    struct vertex *vertices = make_vertices(scene, index, gpu->origin, scratch, err);
    if (!vertices)
        return HATCH_LIMIT;
    gpu->index_count = 3 * mesh->face_count;
    glCreateBuffers(1, &gpu->vertices);
    glCreateBuffers(1, &gpu->indices);
    glNamedBufferStorage(gpu->vertices, (GLsizeiptr)(sizeof *vertices * (mesh->vertex_count + 1u)), NULL,
                         GL_DYNAMIC_STORAGE_BIT);
    glNamedBufferSubData(gpu->vertices, 0, (GLsizeiptr)(sizeof *vertices * mesh->vertex_count), vertices);
    glNamedBufferStorage(gpu->indices, (GLsizeiptr)(sizeof(uint32_t) * (gpu->index_count + 1u)), NULL,
                         GL_DYNAMIC_STORAGE_BIT);
    glNamedBufferSubData(gpu->indices, 0, (GLsizeiptr)(sizeof(uint32_t) * gpu->index_count), mesh->indices);
    if (gpu->patches)
        HATCH_TRY(upload_surface(gpu, scratch, err));
    hatch_arena_rewind(scratch, mark);
    return glGetError() == GL_OUT_OF_MEMORY
               ? hatch_fail(err, HATCH_LIMIT, "mesh %u: the GPU has no memory for it", index)
               : HATCH_OK;
}

static GLuint make_vertex_array(GLuint vertices, GLuint indices)
{
    GLuint array;
    static const struct {
        GLint size;
        GLuint offset;
    } attributes[] = {{3, offsetof(struct vertex, position)},
                      {3, offsetof(struct vertex, normal)},
                      {2, offsetof(struct vertex, texcoord)},
                      {2, offsetof(struct vertex, base_texcoord)}};
    glCreateVertexArrays(1, &array);
    glVertexArrayVertexBuffer(array, 0, vertices, 0, sizeof(struct vertex));
    glVertexArrayElementBuffer(array, indices);
    for (GLuint i = 0; i < sizeof attributes / sizeof *attributes; i++) {
        glEnableVertexArrayAttrib(array, i);
        glVertexArrayAttribFormat(array, i, attributes[i].size, GL_FLOAT, GL_FALSE, attributes[i].offset);
        glVertexArrayAttribBinding(array, i, 0);
    }
    return array;
}

static void make_item(const struct gpu_scene *gpu, uint32_t node, uint32_t mesh, struct gpu_item *item)
{
    const struct hatch_scene *scene = gpu->scene;
    const struct hatch_scene_mesh *from = &scene->meshes[mesh];
    *item = (struct gpu_item){
        .mesh = mesh, .node = node, .repeat = {1.0f, 1.0f}, .double_sided = true, .base_lightness = 1.0f};
    if (from->material != HATCH_NONE) {
        const struct hatch_material *material = &scene->materials[from->material];
        item->double_sided = material->double_sided;
        /* The colour's alpha scales the texture's: so does what is compared with it. */
        item->alpha_cutoff = material->alpha_cutoff / fmaxf(material->base_color[3], 1e-6f);
    }
    if (hatch_pose_shapes(scene, node, &from->mesh)) {
        glCreateBuffers(1, &item->posed);
        glNamedBufferData(item->posed, (GLsizeiptr)(sizeof(struct vertex) * (from->mesh.vertex_count + 1u)), NULL,
                          GL_DYNAMIC_DRAW);
    }
    const struct gpu_mesh *shape = &gpu->meshes[mesh];
    GLuint vertices = item->posed ? item->posed : shape->vertices;
    item->vertex_array = make_vertex_array(vertices, shape->indices);
    if (shape->patches)
        item->surface_array = make_vertex_array(vertices, shape->surface_indices);
}

enum hatch_status scene_upload(const struct hatch_scene *scene, const struct hatch_patch_mesh *patches,
                               const struct hatch_bounds *bounds, struct hatch_arena *arena,
                               struct hatch_arena *scratch, struct gpu_scene *gpu, struct hatch_err *err)
{
    uint32_t count = 0;
    for (uint32_t i = 0; i < scene->node_count; i++)
        count += scene->nodes[i].mesh_count;
    struct gpu_scene made = {.scene = scene, .bounds = *bounds};
    HATCH_TRY(hatch_pose_make(scene, arena, &made.pose, err));
    made.meshes = HATCH_NEW(arena, struct gpu_mesh, scene->mesh_count, err);
    made.items = made.meshes ? HATCH_NEW(arena, struct gpu_item, count, err) : NULL;
    if (!made.items)
        return HATCH_LIMIT;
    for (uint32_t i = 0; i < scene->mesh_count; i++) {
        struct gpu_mesh *mesh = &made.meshes[i];
        mesh->patches = patches && patches[i].patch_count ? &patches[i] : NULL;
        mesh->surface = mesh->patches ? &patches[i].surface : &scene->meshes[i].mesh;
        HATCH_TRY(upload_mesh(scene, i, scratch, mesh, err));
    }
    for (uint32_t node = 0; node < scene->node_count; node++)
        for (uint32_t i = 0; i < scene->nodes[node].mesh_count; i++)
            make_item(&made, node, scene->nodes[node].first_mesh + i, &made.items[made.item_count++]);
    *gpu = made;
    return HATCH_OK;
}

/* The box around the mesh's box, moved. */
static void box_item(const struct gpu_scene *gpu, struct gpu_item *item)
{
    const double *half = gpu->meshes[item->mesh].half;
    for (int r = 0; r < 3; r++) {
        double reach = 0;
        for (int c = 0; c < 3; c++)
            reach += fabs((double)item->to_unit[4 * c + r]) * half[c];
        item->low[r] = (double)item->to_unit[12 + r] - reach;
        item->high[r] = (double)item->to_unit[12 + r] + reach;
    }
}

/* The vertices of the buffer are relative to the mesh's origin, the picture is of the unit scene:
 * both shifts join in doubles, where they cancel without loss. */
static void place_item(const struct gpu_scene *gpu, struct gpu_item *item)
{
    const double *origin = gpu->meshes[item->mesh].origin;
    double world[16], normal[9], largest = 0;
    hatch_pose_matrix(&gpu->pose, item->node, world);
    item->mirrored = hatch_pose_normal_matrix(world, normal);
    for (int c = 0; c < 3; c++)
        for (int r = 0; r < 3; r++) {
            item->to_unit[4 * c + r] = (float)(world[4 * c + r] / gpu->bounds.radius);
            largest = fmax(largest, fabs(normal[3 * c + r]));
        }
    for (int i = 0; i < 9; i++)
        item->normal[i] = largest > 0 ? (float)(normal[i] / largest) : 0.0f;
    for (int r = 0; r < 3; r++) {
        double at = world[12 + r] - gpu->bounds.center[r];
        for (int c = 0; c < 3; c++)
            at += world[4 * c + r] * origin[c];
        item->to_unit[12 + r] = (float)(at / gpu->bounds.radius);
        item->to_unit[4 * r + 3] = 0.0f;
    }
    item->to_unit[15] = 1.0f;
    box_item(gpu, item);
}

static enum hatch_status pose_item(struct gpu_scene *gpu, struct gpu_item *item, struct hatch_arena *scratch,
                                   struct hatch_err *err)
{
    static const float unit[16] = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};
    static const float straight[9] = {1, 0, 0, 0, 1, 0, 0, 0, 1};
    const double zero[3] = {0, 0, 0};
    size_t count = gpu->scene->meshes[item->mesh].mesh.vertex_count;
    struct vertex *vertices = make_vertices(gpu->scene, item->mesh, zero, scratch, err);
    double *positions = vertices ? HATCH_NEW(scratch, double, 3 * count, err) : NULL;
    float *normals = positions ? HATCH_NEW(scratch, float, 3 * count, err) : NULL;
    if (!normals)
        return HATCH_LIMIT;
    hatch_pose_vertices(&gpu->pose, item->node, item->mesh, positions, normals);
    for (size_t v = 0; v < count; v++)
        for (size_t k = 0; k < 3; k++) {
            double at = (positions[3 * v + k] - gpu->bounds.center[k]) / gpu->bounds.radius;
            vertices[v].position[k] = (float)at;
            vertices[v].normal[k] = normals[3 * v + k];
            item->low[k] = v ? fmin(item->low[k], at) : at;
            item->high[k] = v ? fmax(item->high[k], at) : at;
        }
    glNamedBufferSubData(item->posed, 0, (GLsizeiptr)(sizeof *vertices * count), vertices);
    memcpy(item->to_unit, unit, sizeof unit);
    memcpy(item->normal, straight, sizeof straight);
    if (gpu->scene->nodes[item->node].skin == HATCH_NONE) {
        double world[16], cofactors[9];
        hatch_pose_matrix(&gpu->pose, item->node, world);
        item->mirrored = hatch_pose_normal_matrix(world, cofactors);
    }
    return item->tangents ? normals_pose(gpu, item, positions, scratch, err) : HATCH_OK;
}

enum hatch_status scene_set_pose(struct gpu_scene *gpu, uint32_t animation, double time_s, struct hatch_arena *scratch,
                                 struct hatch_err *err)
{
    if (!gpu->pose_number || animation != gpu->animation || time_s < gpu->time_s || time_s > gpu->time_s)
        gpu->pose_number++;
    gpu->animation = animation;
    gpu->time_s = time_s;
    hatch_pose_at(&gpu->pose, animation, time_s);
    for (uint32_t i = 0; i < gpu->item_count; i++) {
        struct gpu_item *item = &gpu->items[i];
        struct hatch_arena_mark mark = hatch_arena_mark(scratch);
        enum hatch_status status = HATCH_OK;
        if (item->posed)
            status = pose_item(gpu, item, scratch, err);
        else
            place_item(gpu, item);
        hatch_arena_rewind(scratch, mark);
        HATCH_TRY(status);
    }
    return HATCH_OK;
}

void scene_set_spans(struct gpu_item *item, const float *spans, uint32_t count)
{
    const GLuint binding = 3, step = 6 * sizeof *spans;
    glCreateBuffers(1, &item->spans);
    glNamedBufferStorage(item->spans, (GLsizeiptr)((size_t)step * count), spans, 0);
    glVertexArrayVertexBuffer(item->vertex_array, binding, item->spans, 0, (GLsizei)step);
    for (GLuint k = 0; k < 2; k++) {
        glEnableVertexArrayAttrib(item->vertex_array, SPANS_ATTRIBUTE + k);
        glVertexArrayAttribFormat(item->vertex_array, SPANS_ATTRIBUTE + k, 3, GL_FLOAT, GL_FALSE, k * step / 2);
        glVertexArrayAttribBinding(item->vertex_array, SPANS_ATTRIBUTE + k, binding);
    }
}

static enum hatch_status make_patch_tones(struct gpu_mesh *mesh, struct hatch_arena *scratch, struct hatch_err *err)
{
    const struct hatch_patch_mesh *patches = mesh->patches;
    struct hatch_arena_mark mark = hatch_arena_mark(scratch);
    uint32_t count = patches->first_vertex[patches->patch_count];
    float *tones = HATCH_NEW(scratch, float, count + (size_t)1, err);
    if (!tones)
        return HATCH_LIMIT;
    for (uint32_t patch = 0; patch < patches->patch_count; patch++)
        for (uint32_t v = patches->first_vertex[patch]; v < patches->first_vertex[patch + 1]; v++)
            tones[v] = 1.0f - powf(0.3f + 0.7f * hatch_random_unit(1, 0, patch), 2.2f); /* even to the eye */
    glCreateBuffers(1, &mesh->patch_tones);
    glNamedBufferStorage(mesh->patch_tones, (GLsizeiptr)(sizeof *tones * (count + 1u)), tones, 0);
    hatch_arena_rewind(scratch, mark);
    return HATCH_OK;
}

enum hatch_status scene_tell_patches(struct gpu_scene *gpu, struct hatch_arena *scratch, struct hatch_err *err)
{
    for (uint32_t i = 0; i < gpu->item_count; i++) {
        GLuint array = gpu->items[i].vertex_array;
        struct gpu_mesh *mesh = &gpu->meshes[gpu->items[i].mesh];
        if (!mesh->patches)
            continue;
        if (!mesh->patch_tones)
            HATCH_TRY(make_patch_tones(mesh, scratch, err));
        glVertexArrayVertexBuffer(array, 2, mesh->patch_tones, 0, sizeof(float));
        glEnableVertexArrayAttrib(array, PATCH_ATTRIBUTE);
        glVertexArrayAttribFormat(array, PATCH_ATTRIBUTE, 1, GL_FLOAT, GL_FALSE, 0);
        glVertexArrayAttribBinding(array, PATCH_ATTRIBUTE, 2);
    }
    return HATCH_OK;
}

void scene_set_repeats(struct gpu_item *item, const float *repeats, uint32_t count)
{
    glDeleteBuffers(1, &item->repeats);
    item->repeats = 0;
    item->repeats_set++;
    glDisableVertexArrayAttrib(item->vertex_array, REPEAT_ATTRIBUTE);
    if (!repeats || !count)
        return;
    glCreateBuffers(1, &item->repeats);
    glNamedBufferStorage(item->repeats, (GLsizeiptr)(2 * sizeof *repeats * count), repeats, 0);
    glVertexArrayVertexBuffer(item->vertex_array, 1, item->repeats, 0, 2 * sizeof *repeats);
    glEnableVertexArrayAttrib(item->vertex_array, REPEAT_ATTRIBUTE);
    glVertexArrayAttribFormat(item->vertex_array, REPEAT_ATTRIBUTE, 2, GL_FLOAT, GL_FALSE, 0);
    glVertexArrayAttribBinding(item->vertex_array, REPEAT_ATTRIBUTE, 1);
}

void scene_free(struct gpu_scene *gpu)
{
    for (uint32_t i = 0; i < gpu->item_count; i++) {
        glDeleteVertexArrays(1, &gpu->items[i].vertex_array);
        glDeleteVertexArrays(1, &gpu->items[i].surface_array);
        glDeleteBuffers(1, &gpu->items[i].posed);
        glDeleteBuffers(1, &gpu->items[i].repeats);
        glDeleteBuffers(1, &gpu->items[i].spans);
        normals_free(&gpu->items[i]);
    }
    for (uint32_t i = 0; gpu->meshes && i < gpu->scene->mesh_count; i++) {
        glDeleteBuffers(1, &gpu->meshes[i].vertices);
        glDeleteBuffers(1, &gpu->meshes[i].indices);
        glDeleteBuffers(1, &gpu->meshes[i].surface_indices);
        glDeleteBuffers(1, &gpu->meshes[i].patch_tones);
    }
    *gpu = (struct gpu_scene){0};
}
