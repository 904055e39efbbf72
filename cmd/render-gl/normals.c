#include "render-gl/normals.h"

#include <stddef.h>
#include <string.h>

#include "math/vector.h"
#include "render-gl/material.h"

/* The frames of a mesh at rest, for its normals' texture coordinates. */
static enum hatch_status make_tangents(const struct hatch_mesh *from, const struct hatch_normal_map *normals,
                                       struct hatch_arena *arena, struct hatch_arena *scratch,
                                       struct tangent **tangents, struct hatch_err *err)
{
    struct hatch_mesh mesh = *from;
    const struct hatch_texture_use *at = &normals->at;
    const float *texcoord = scene_texcoords(from, at->texcoord);
    float *placed;
    struct tangent *made = HATCH_NEW(arena, struct tangent, from->vertex_count, err);
    if (!made)
        return HATCH_LIMIT;
    mesh.attribute_count = 0;
    for (uint32_t i = 0; i < from->attribute_count; i++)
        if (strncmp(from->attributes[i].name, "TEXCOORD_", 9) != 0)
            mesh.attributes[mesh.attribute_count++] = from->attributes[i];
    HATCH_TRY(hatch_mesh_add(arena, &mesh, "TEXCOORD_0", 2, &placed, err));
    for (size_t v = 0; v < mesh.vertex_count; v++) {
        memcpy(&placed[2 * v], &texcoord[2 * v], 2 * sizeof *placed);
        if (at->placed)
            scene_place(at->scale, at->turn_rad, at->offset, &placed[2 * v]);
    }
    HATCH_TRY(hatch_mesh_add_tangents(arena, scratch, &mesh, err));
    const float *along = hatch_mesh_find(&mesh, "TANGENT", 4);
    for (size_t v = 0; v < mesh.vertex_count; v++) {
        memcpy(made[v].along, &along[4 * v], sizeof made[v].along);
        memcpy(made[v].texcoord, &placed[2 * v], sizeof made[v].texcoord);
    }
    *tangents = made;
    return HATCH_OK;
}

static const struct hatch_normal_map *map_of(const struct gpu_scene *gpu, const struct gpu_item *item)
{
    const struct hatch_scene_mesh *mesh = &gpu->scene->meshes[item->mesh];
    if (mesh->material == HATCH_NONE)
        return NULL;
    const struct hatch_normal_map *normals = &gpu->scene->materials[mesh->material].normals;
    return normals->used && scene_texcoords(&mesh->mesh, normals->at.texcoord) ? normals : NULL;
}

static void bind(GLuint vertex_array, GLuint tangents)
{
    const GLuint binding = 4;
    glVertexArrayVertexBuffer(vertex_array, binding, tangents, 0, sizeof(struct tangent));
    for (GLuint k = 0; k < 2; k++) {
        glEnableVertexArrayAttrib(vertex_array, TANGENT_ATTRIBUTE + k);
        glVertexArrayAttribFormat(vertex_array, TANGENT_ATTRIBUTE + k, k ? 2 : 4, GL_FLOAT, GL_FALSE,
                                  k ? offsetof(struct tangent, texcoord) : 0);
        glVertexArrayAttribBinding(vertex_array, TANGENT_ATTRIBUTE + k, binding);
    }
}

enum hatch_status normals_set(const struct gpu_scene *gpu, struct gpu_item *item,
                              const struct hatch_normal_map *normals, GLuint texture, struct hatch_arena *arena,
                              struct hatch_arena *scratch, struct hatch_err *err)
{
    const struct hatch_mesh *mesh = &gpu->scene->meshes[item->mesh].mesh;
    struct tangent *tangents;
    HATCH_TRY(make_tangents(mesh, normals, arena, scratch, &tangents, err));
    item->rest = tangents;
    item->normals = texture;
    item->normals_strength = normals->strength;
    glCreateBuffers(1, &item->tangents);
    glNamedBufferData(item->tangents, (GLsizeiptr)(sizeof *tangents * mesh->vertex_count), tangents, GL_DYNAMIC_DRAW);
    bind(item->vertex_array, item->tangents);
    if (item->surface_array)
        bind(item->surface_array, item->tangents);
    return HATCH_OK;
}

void normals_upload(struct cmd_args *args, const char *file, uint32_t size_max_px, struct gpu_scene *gpu)
{
    for (uint32_t i = 0; i < gpu->item_count; i++) {
        struct gpu_item *item = &gpu->items[i];
        const struct hatch_normal_map *normals = map_of(gpu, item);
        struct hatch_err err;
        if (!normals)
            continue;
        GLuint texture = material_normals(args, file, gpu->scene, normals, size_max_px);
        cmd_check(normals_set(gpu, item, normals, texture, &args->keep, &args->scratch, &err), file, &err);
    }
}

enum hatch_status normals_pose(const struct gpu_scene *gpu, const struct gpu_item *item, const double *positions,
                               struct hatch_arena *scratch, struct hatch_err *err)
{
    struct hatch_pose pose = gpu->pose;
    struct hatch_mesh ahead = gpu->scene->meshes[item->mesh].mesh;
    size_t count = ahead.vertex_count;
    struct tangent *tangents = HATCH_NEW(scratch, struct tangent, count, err);
    double *moved = tangents ? HATCH_NEW(scratch, double, 3 * count, err) : NULL;
    float *places = moved ? HATCH_NEW(scratch, float, 3 * count, err) : NULL;
    if (!places)
        return HATCH_LIMIT;
    memcpy(tangents, item->rest, sizeof *tangents * count);
    /* A tangent goes where the place goes that lies ahead along it. */
    for (uint32_t i = 0; i < ahead.attribute_count; i++)
        if (strcmp(ahead.attributes[i].name, "POSITION") == 0) {
            for (size_t k = 0; k < 3 * count; k++)
                places[k] = ahead.attributes[i].data[k] + tangents[k / 3].along[k % 3];
            ahead.attributes[i].data = places;
        }
    hatch_pose_mesh(&pose, item->node, &ahead, moved, NULL);
    for (size_t v = 0; v < count; v++) {
        double along[3];
        hatch_vec_sub(&moved[3 * v], &positions[3 * v], along);
        hatch_vec_normalize(along);
        hatch_vec_round(along, tangents[v].along);
    }
    glNamedBufferSubData(item->tangents, 0, (GLsizeiptr)(sizeof *tangents * count), tangents);
    return HATCH_OK;
}

void normals_free(struct gpu_item *item)
{
    glDeleteTextures(1, &item->normals);
    glDeleteBuffers(1, &item->tangents);
}
