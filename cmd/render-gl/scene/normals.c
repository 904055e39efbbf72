#include "render-gl/scene/normals.h"

#include <math.h>
#include <stddef.h>
#include <string.h>

#include "math/vector.h"
#include "render-gl/gpu/bindings.h"
#include "render-gl/gpu/buffer.h"
#include "render-gl/scene/material.h"

/* Computes the tangent frames of a mesh at rest for those texture coordinates that its normal map uses. */
static enum hatch_status make_tangents(const struct hatch_mesh *from, const struct hatch_normal_map *normals,
                                       struct hatch_arena *arena, struct hatch_arena *scratch,
                                       struct scene_tangent **tangents, struct hatch_err *err)
{
    struct hatch_mesh mesh = *from;
    const struct hatch_texture_use *at = &normals->at;
    const float *texcoord = scene_texcoords(from, at->texcoord);
    float *placed;
    struct scene_tangent *made = HATCH_NEW(arena, struct scene_tangent, from->vertex_count, err);
    if (!made)
        return HATCH_LIMIT;
    mesh.attribute_count = 0;
    for (uint32_t i = 0; i < from->attribute_count; i++)
        if (strncmp(from->attributes[i].name, "TEXCOORD_", 9) != 0)
            mesh.attributes[mesh.attribute_count++] = from->attributes[i];
    HATCH_TRY(hatch_mesh_add(arena, &mesh, "TEXCOORD_0", 2, &placed, err));
    for (size_t v = 0; v < mesh.vertex_count; v++) {
        memcpy(&placed[2 * v], &texcoord[2 * v], 2 * sizeof *placed);
        scene_place_texcoord(at, &placed[2 * v]);
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

static const struct hatch_normal_map *map_of(const struct scene *scene, uint32_t index)
{
    const struct hatch_scene_mesh *mesh = &scene->unit.scene->meshes[scene->unit.items[index].mesh];
    if (mesh->material == HATCH_NONE)
        return NULL;
    const struct hatch_normal_map *normals = &scene->unit.scene->materials[mesh->material].normals;
    return normals->used && scene_texcoords(&mesh->mesh, normals->at.texcoord) ? normals : NULL;
}

/* Returns the normal map of an earlier item that uses the same texture in the same way, or 0. */
static GLuint find_same_map(const struct scene *scene, uint32_t index, const struct hatch_normal_map *wanted)
{
    for (uint32_t i = 0; i < index; i++) {
        const struct hatch_normal_map *has = scene->items[i].normals ? map_of(scene, i) : NULL;
        if (has && has->at.texture == wanted->at.texture && has->at.wrap[0] == wanted->at.wrap[0] &&
            has->at.wrap[1] == wanted->at.wrap[1])
            return scene->items[i].normals;
    }
    return 0;
}

enum hatch_status normals_set(struct scene *scene, uint32_t index, const struct hatch_normal_map *normals,
                              GLuint texture, struct hatch_arena *arena, struct hatch_arena *scratch,
                              struct hatch_err *err)
{
    static const struct gpu_attribute attributes[] = {
        {ATTRIBUTE_TANGENT, 4, GL_FLOAT, 0},
        {ATTRIBUTE_NORMAL_TEXCOORD, 2, GL_FLOAT, offsetof(struct scene_tangent, texcoord)}};
    const struct hatch_mesh *mesh = scene->unit.meshes[scene->unit.items[index].mesh].mesh;
    struct scene_item *item = &scene->items[index];
    const GLuint arrays[] = {item->vertex_array, item->surface_array};
    struct scene_tangent *tangents;
    HATCH_TRY(make_tangents(mesh, normals, arena, scratch, &tangents, err));
    item->rest = tangents;
    item->normals = texture;
    item->normals_strength = normals->strength;
    item->tangents = gpu_buffer_make(tangents, sizeof *tangents * mesh->vertex_count);
    for (int i = 0; i < 2; i++)
        if (arrays[i])
            gpu_array_attach(arrays[i], SCENE_SLOT_TANGENTS, item->tangents, sizeof *tangents, attributes, 2);
    return HATCH_OK;
}

void normals_upload(struct cmd_args *args, const char *file, uint32_t size_max_px, struct scene *scene)
{
    for (uint32_t i = 0; i < scene->unit.item_count; i++) {
        const struct hatch_normal_map *normals = map_of(scene, i);
        struct hatch_err err;
        if (!normals)
            continue;
        GLuint texture = find_same_map(scene, i, normals);
        if (!texture)
            texture = material_normals(args, file, scene->unit.scene, normals, size_max_px);
        cmd_check(normals_set(scene, i, normals, texture, &args->keep, &args->scratch, &err), file, &err);
    }
}

/* Returns a power of two that is larger than all numbers. */
static float step_beyond(const float *numbers, size_t count)
{
    float most = 0;
    int power;
    for (size_t i = 0; i < count; i++)
        most = fmaxf(most, fabsf(numbers[i]));
    frexpf(most, &power);
    return ldexpf(1, power);
}

enum hatch_status normals_pose(const struct scene *scene, uint32_t index, const double *positions,
                               struct hatch_arena *scratch, struct hatch_err *err)
{
    const struct hatch_item *unit = &scene->unit.items[index];
    const struct scene_item *item = &scene->items[index];
    struct hatch_pose pose = scene->unit.pose; /* a copy: only its scratch arrays are written */
    struct hatch_mesh ahead = *scene->unit.meshes[unit->mesh].mesh;
    size_t count = ahead.vertex_count;
    struct scene_tangent *tangents = HATCH_NEW(scratch, struct scene_tangent, count, err);
    double *moved = tangents ? HATCH_NEW(scratch, double, 3 * count, err) : NULL;
    float *places = moved ? HATCH_NEW(scratch, float, 3 * count, err) : NULL;
    if (!places)
        return HATCH_LIMIT;
    memcpy(tangents, item->rest, sizeof *tangents * count);
    /* To pose a tangent, pose a point that lies ahead of the vertex, farther than any is from the origin, and subtract
     * the posed vertex. */
    for (uint32_t i = 0; i < ahead.attribute_count; i++)
        if (strcmp(ahead.attributes[i].name, "POSITION") == 0) {
            const float *from = ahead.attributes[i].data;
            const float step = step_beyond(from, 3 * count);
            for (size_t k = 0; k < 3 * count; k++)
                places[k] = from[k] + step * tangents[k / 3].along[k % 3];
            ahead.attributes[i].data = places;
        }
    hatch_pose_mesh(&pose, unit->node, &ahead, moved, NULL);
    for (size_t v = 0; v < count; v++) {
        double along[3];
        hatch_vec_sub(&moved[3 * v], &positions[3 * v], along);
        hatch_vec_normalize(along);
        hatch_vec_round(along, tangents[v].along);
        tangents[v].along[3] *= unit->mirrored ? -1.0f : 1.0f; /* the vertex stage knows no matrix of posed points */
    }
    gpu_buffer_update(item->tangents, tangents, sizeof *tangents * count);
    return HATCH_OK;
}
