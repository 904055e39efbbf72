/* Lapped scenes for tests: a surface is cut into patches by a rule. */
#ifndef HATCH_TEST_LAPPED_SCENE_H
#define HATCH_TEST_LAPPED_SCENE_H

#include <math.h>
#include <string.h>

#include "run.h"
#include "scene/patches.h"

enum { LAPPED_SIZE = 64 }; /* side of the map and of the outline in texels */

/* A rule by which a surface is cut into patches. */
struct cut {
    uint32_t count;
    uint32_t materials; /* patch i has material i % materials */
    /* Returns whether a patch has the face with this centroid; NULL: it has all. */
    bool (*holds)(uint32_t patch, const double point[3]);
    /* Sets the hatch and outline coordinates of a vertex. */
    void (*place)(uint32_t patch, const float *position, float hatch[2], float outline[2]);
};

static inline void middle_of(const struct hatch_mesh *mesh, size_t face, double middle[3])
{
    for (size_t k = 0; k < 3; k++) {
        middle[k] = 0;
        for (size_t c = 0; c < 3; c++)
            middle[k] += (double)mesh->attributes[0].data[3 * (size_t)mesh->indices[3 * face + c] + k] / 3;
    }
}

/* Makes a patch with the attributes of the surface, but with texture coordinates from cut->place. Patches differ in the
 * corner at which their faces start. */
static inline struct hatch_mesh patch_of(const struct hatch_mesh *surface, const struct cut *cut, uint32_t patch,
                                         struct hatch_arena *arena, struct hatch_err *err)
{
    struct hatch_mesh made;
    uint32_t *now = HATCH_NEW(arena, uint32_t, surface->vertex_count, err); /* new index + 1; 0: unused */
    uint32_t *old = HATCH_NEW(arena, uint32_t, surface->vertex_count, err);
    HATCH_TEST_OK(hatch_mesh_make(arena, surface->vertex_count, surface->face_count, &made, err), err);
    made.vertex_count = made.face_count = 0;
    for (size_t f = 0; f < surface->face_count; f++) {
        double middle[3];
        middle_of(surface, f, middle);
        if (cut->holds && !cut->holds(patch, middle))
            continue;
        for (size_t c = 0; c < 3; c++) {
            uint32_t vertex = surface->indices[3 * f + (c + patch) % 3];
            if (!now[vertex]) {
                old[made.vertex_count] = vertex;
                now[vertex] = ++made.vertex_count;
            }
            made.indices[3 * (size_t)made.face_count + c] = now[vertex] - 1;
        }
        made.face_count++;
    }
    float *hatch, *outline;
    for (uint32_t a = 0; a < surface->attribute_count; a++) {
        const struct hatch_mesh_attribute *from = &surface->attributes[a];
        float *data = made.attributes[0].data;
        if (strncmp(from->name, "TEXCOORD", 8) == 0)
            continue;
        if (a > 0)
            HATCH_TEST_OK(hatch_mesh_add(arena, &made, from->name, from->components, &data, err), err);
        for (size_t v = 0; v < made.vertex_count; v++)
            memcpy(data + from->components * v, from->data + from->components * old[v],
                   from->components * sizeof *data);
    }
    HATCH_TEST_OK(hatch_mesh_add(arena, &made, "TEXCOORD_0", 2, &hatch, err), err);
    HATCH_TEST_OK(hatch_mesh_add(arena, &made, "TEXCOORD_1", 2, &outline, err), err);
    for (size_t v = 0; v < made.vertex_count; v++)
        cut->place(patch, made.attributes[0].data + 3 * v, hatch + 2 * v, outline + 2 * v);
    return made;
}

/* Makes a scene of one node whose meshes are the patches, as before hatch_patches_join. */
static inline void lapped_scene(const struct hatch_mesh *surface, const struct cut *cut, struct hatch_arena *arena,
                                struct hatch_scene *scene)
{
    struct hatch_err made = {0}, *err = &made;
    HATCH_TEST_OK(hatch_scene_of_mesh(surface, arena, scene, err), err);
    scene->meshes = HATCH_NEW(arena, struct hatch_scene_mesh, cut->count, err);
    scene->materials = HATCH_NEW(arena, struct hatch_material, 2, err);
    scene->textures = HATCH_NEW(arena, struct hatch_texture, 1, err);
    scene->material_count = 2;
    scene->texture_count = 1;
    for (int i = 0; i < 2; i++)
        scene->materials[i] = (struct hatch_material){
            .base_color = {1, 1, 1, 1}, .base.texcoord = 1, .double_sided = true, .outline = true};
    scene->mesh_count = scene->nodes[0].mesh_count = cut->count;
    for (uint32_t i = 0; i < cut->count; i++)
        scene->meshes[i] = (struct hatch_scene_mesh){
            .mesh = patch_of(surface, cut, i, arena, err), .material = i % cut->materials, .had_normals = true};
}

/* Offsets of the texture coordinates of each patch, in texels: u and v of the map, u and v of the outline. */
static const int shifts[4][4] = {{0, 0, 0, 0}, {5, 40, 11, -7}, {23, 9, -20, 3}, {50, 31, 2, 17}};

static inline void place_shifted(uint32_t patch, const float *position, float hatch[2], float outline[2])
{
    double uv[2] = {0.5 + 0.5 * (double)position[0], 0.5 - 0.5 * (double)position[1]};
    for (int k = 0; k < 2; k++) {
        hatch[k] = (float)(uv[k] + shifts[patch][k] / (double)LAPPED_SIZE);
        outline[k] = (float)(uv[k] + shifts[patch][2 + k] / (double)LAPPED_SIZE);
    }
}

/* Patches that are caps of a sphere around the points of a spiral. Each is projected onto the tangent plane at its
 * point. */
enum { CAPS = 40 };
static const double CAP_COS = 0.86;

static inline void cap_axes(uint32_t patch, double axes[3][3])
{
    double y = 1 - (2.0 * patch + 1) / CAPS, angle = 2.399963 * patch, r = sqrt(1 - y * y);
    double up[3] = {r * cos(angle), y, r * sin(angle)}, east[3] = {-sin(angle), 0, cos(angle)};
    for (int k = 0; k < 3; k++) {
        axes[0][k] = east[k];
        axes[2][k] = up[k];
    }
    for (int k = 0; k < 3; k++)
        axes[1][k] = up[(k + 1) % 3] * east[(k + 2) % 3] - up[(k + 2) % 3] * east[(k + 1) % 3];
}

static inline double along(const double axis[3], const double point[3])
{
    return axis[0] * point[0] + axis[1] * point[1] + axis[2] * point[2];
}

static inline bool cap_holds(uint32_t patch, const double point[3])
{
    double axes[3][3];
    cap_axes(patch, axes);
    return along(axes[2], point) > CAP_COS * sqrt(along(point, point));
}

static inline void cap_place(uint32_t patch, const float *position, float hatch[2], float outline[2])
{
    double axes[3][3], point[3] = {(double)position[0], (double)position[1], (double)position[2]};
    double size = 2 * sqrt(1 - CAP_COS * CAP_COS);
    cap_axes(patch, axes);
    for (int k = 0; k < 2; k++) {
        double at = along(axes[k], point) / sqrt(along(point, point));
        hatch[k] = (float)at;
        outline[k] = (float)(0.5 + at / (1.02 * size));
    }
}

static const struct cut caps = {.count = CAPS, .materials = 1, .holds = cap_holds, .place = cap_place};

/* Adds a skin of two joints; the first one is rotated and moved to the right. */
static inline void lapped_scene_skin(struct hatch_scene *scene, struct hatch_arena *arena)
{
    struct hatch_err err = {0};
    struct hatch_node *nodes = HATCH_NEW(arena, struct hatch_node, 3, &err);
    scene->skins = HATCH_NEW(arena, struct hatch_skin, 1, &err);
    scene->skins[0] = (struct hatch_skin){.joint_count = 2,
                                          .joints = HATCH_NEW(arena, uint32_t, 2, &err),
                                          .inverse_bind = HATCH_NEW(arena, float, 32, &err)};
    for (uint32_t j = 0; j < 2; j++) {
        scene->skins[0].joints[j] = 1 + j;
        for (uint32_t i = 0; i < 4; i++)
            scene->skins[0].inverse_bind[16 * j + 5 * i] = 1;
    }
    nodes[0] = nodes[1] = nodes[2] = scene->nodes[0];
    nodes[0].skin = 0;
    nodes[1].mesh_count = nodes[2].mesh_count = 0;
    nodes[1].translation[0] = 0.1f;
    nodes[1].rotation[2] = -0.1f;
    nodes[1].rotation[3] = sqrtf(0.99f);
    scene->nodes = nodes;
    scene->node_count = 3;
    scene->skin_count = 1;
}

#endif
