#include "scene/row.h"

#include <string.h>

#define GAP 0.2 /* between neighbours, in radii of the first scene */

static uint32_t shifted(uint32_t index, uint32_t offset)
{
    return index == HATCH_NONE ? HATCH_NONE : index + offset;
}

static void append_nodes(const struct hatch_scene *from, uint32_t root, struct hatch_scene *to)
{
    uint32_t first = to->node_count;
    for (uint32_t i = 0; i < from->node_count; i++) {
        struct hatch_node node = from->nodes[i];
        node.parent = node.parent == HATCH_NONE ? root : node.parent + first;
        node.first_mesh += to->mesh_count;
        node.skin = shifted(node.skin, to->skin_count);
        node.camera = shifted(node.camera, to->camera_count);
        node.light = shifted(node.light, to->light_count);
        to->nodes[to->node_count++] = node;
    }
    for (uint32_t i = 0; i < from->mesh_count; i++) {
        to->meshes[to->mesh_count] = from->meshes[i];
        uint32_t *material = &to->meshes[to->mesh_count++].material;
        *material = shifted(*material, to->material_count);
    }
    for (uint32_t i = 0; i < from->material_count; i++) {
        to->materials[to->material_count] = from->materials[i];
        struct hatch_material *material = &to->materials[to->material_count++];
        material->base.texture = shifted(material->base.texture, to->texture_count);
        material->normals.at.texture = shifted(material->normals.at.texture, to->texture_count);
    }
}

static enum hatch_status append_skins(const struct hatch_scene *from, uint32_t first_node, struct hatch_scene *to,
                                      struct hatch_arena *arena, struct hatch_err *err)
{
    for (uint32_t i = 0; i < from->skin_count; i++) {
        struct hatch_skin skin = from->skins[i];
        HATCH_TRY(HATCH_ALLOC(arena, &skin.joints, skin.joint_count, err));
        for (uint32_t j = 0; j < skin.joint_count; j++)
            skin.joints[j] = from->skins[i].joints[j] + first_node;
        to->skins[to->skin_count++] = skin;
    }
    return HATCH_OK;
}

static enum hatch_status append_animations(const struct hatch_scene *from, uint32_t first_node, struct hatch_scene *to,
                                           struct hatch_arena *arena, struct hatch_err *err)
{
    for (uint32_t i = 0; i < from->animation_count; i++) {
        const struct hatch_animation *more = &from->animations[i];
        struct hatch_animation *all = &to->animations[i];
        struct hatch_animation_channel *channels;
        HATCH_TRY(HATCH_ALLOC(arena, &channels, all->channel_count + more->channel_count, err));
        if (all->channel_count)
            memcpy(channels, all->channels, all->channel_count * sizeof *channels);
        for (uint32_t c = 0; c < more->channel_count; c++) {
            channels[all->channel_count + c] = more->channels[c];
            channels[all->channel_count + c].node += first_node;
        }
        all->channels = channels;
        all->channel_count += more->channel_count;
        if (more->duration_s > all->duration_s)
            all->duration_s = more->duration_s;
    }
    if (from->animation_count > to->animation_count)
        to->animation_count = from->animation_count;
    return HATCH_OK;
}

/* Appends cameras and lights whose scene is `size` times as large: they see, and light, the same of it. */
static void append_views(const struct hatch_scene *from, float size, struct hatch_scene *to)
{
    for (uint32_t i = 0; i < from->camera_count; i++) {
        struct hatch_camera *camera = &to->cameras[to->camera_count++];
        *camera = from->cameras[i];
        camera->ymag *= size;
        camera->znear *= size;
        camera->zfar *= size;
    }
    for (uint32_t i = 0; i < from->light_count; i++) {
        struct hatch_light *light = &to->lights[to->light_count++];
        *light = from->lights[i];
        light->range *= size;
        if (light->type != HATCH_LIGHT_DIRECTIONAL)
            light->intensity *= size * size;
    }
}

/* Appends a scene under a root node, which makes it `size` times as large. */
static enum hatch_status append(const struct hatch_scene *from, const struct hatch_node *root, float size,
                                struct hatch_scene *to, struct hatch_arena *arena, struct hatch_err *err)
{
    uint32_t root_index = to->node_count, first = root_index + 1;
    to->nodes[to->node_count++] = *root;
    append_nodes(from, root_index, to);
    HATCH_TRY(append_skins(from, first, to, arena, err));
    HATCH_TRY(append_animations(from, first, to, arena, err));
    /* These contain no indices; the indices that refer to them have been shifted above. */
    for (uint32_t i = 0; i < from->texture_count; i++)
        to->textures[to->texture_count++] = from->textures[i];
    append_views(from, size, to);
    return HATCH_OK;
}

/* Makes an empty scene whose arrays have room for the content of all scenes, and for a root node for each. */
static enum hatch_status make_room(const struct hatch_scene *scenes, uint32_t count, struct hatch_arena *arena,
                                   struct hatch_scene *made, struct hatch_err *err)
{
    struct hatch_scene all = {.node_count = count};
    for (uint32_t i = 0; i < count; i++) {
        all.node_count += scenes[i].node_count;
        all.mesh_count += scenes[i].mesh_count;
        all.material_count += scenes[i].material_count;
        all.texture_count += scenes[i].texture_count;
        all.camera_count += scenes[i].camera_count;
        all.light_count += scenes[i].light_count;
        all.skin_count += scenes[i].skin_count;
        all.animation_count += scenes[i].animation_count;
    }
    *made = (struct hatch_scene){0};
    HATCH_TRY(HATCH_ALLOC(arena, &made->nodes, all.node_count, err));
    HATCH_TRY(HATCH_ALLOC(arena, &made->meshes, all.mesh_count, err));
    HATCH_TRY(HATCH_ALLOC(arena, &made->materials, all.material_count, err));
    HATCH_TRY(HATCH_ALLOC(arena, &made->textures, all.texture_count, err));
    HATCH_TRY(HATCH_ALLOC(arena, &made->cameras, all.camera_count, err));
    HATCH_TRY(HATCH_ALLOC(arena, &made->lights, all.light_count, err));
    HATCH_TRY(HATCH_ALLOC(arena, &made->skins, all.skin_count, err));
    return HATCH_ALLOC(arena, &made->animations, all.animation_count, err);
}

enum hatch_status hatch_scene_turn_up(struct hatch_scene *scene, enum hatch_up up, struct hatch_arena *arena,
                                      struct hatch_err *err)
{
    static const double z_to_y[16] = {1, 0, 0, 0, 0, 0, -1, 0, 0, 1, 0, 0, 0, 0, 0, 1};
    static const double x_to_y[16] = {0, 1, 0, 0, -1, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};
    struct hatch_node root = {
        .parent = HATCH_NONE, .has_matrix = true, .skin = HATCH_NONE, .camera = HATCH_NONE, .light = HATCH_NONE};
    struct hatch_scene turned;
    if (up == HATCH_UP_Y)
        return HATCH_OK;
    memcpy(root.matrix, up == HATCH_UP_Z ? z_to_y : x_to_y, sizeof root.matrix);
    HATCH_TRY(make_room(scene, 1, arena, &turned, err));
    HATCH_TRY(append(scene, &root, 1, &turned, arena, err));
    *scene = turned;
    return HATCH_OK;
}

enum hatch_status hatch_scene_measure(const struct hatch_scene *scene, const struct hatch_pose_span *span,
                                      struct hatch_arena *scratch, struct hatch_bounds *bounds, struct hatch_err *err)
{
    static const struct hatch_pose_span rest = {.animation = HATCH_NONE, .moments = 1};
    struct hatch_arena_mark mark = hatch_arena_mark(scratch);
    struct hatch_pose pose;
    enum hatch_status status = hatch_pose_make(scene, scratch, &pose, err);
    if (status == HATCH_OK)
        status = hatch_pose_bounds(&pose, span ? span : &rest, scratch, bounds, err);
    hatch_arena_rewind(scratch, mark);
    return status;
}

enum hatch_status hatch_scene_join_row(const struct hatch_scene *scenes, uint32_t count, bool stand,
                                       struct hatch_arena *arena, struct hatch_arena *scratch,
                                       struct hatch_scene *joined, struct hatch_err *err)
{
    struct hatch_scene made;
    struct hatch_bounds first = {.radius = 1};
    double x = 0;
    HATCH_TRY(make_room(scenes, count, arena, &made, err));
    for (uint32_t i = 0; i < count; i++) {
        struct hatch_bounds bounds;
        HATCH_TRY(hatch_scene_measure(&scenes[i], NULL, scratch, &bounds, err));
        if (i == 0)
            first = bounds;
        double size = first.radius / bounds.radius, left = bounds.half[0] * size;
        x += i ? left + GAP * first.radius : 0;
        struct hatch_node root = {.parent = HATCH_NONE,
                                  .rotation = {0, 0, 0, 1},
                                  .skin = HATCH_NONE,
                                  .camera = HATCH_NONE,
                                  .light = HATCH_NONE};
        for (int k = 0; k < 3; k++) {
            root.scale[k] = size;
            root.translation[k] = first.center[k] + (k == 0 ? x : 0) - size * bounds.center[k];
            if (k == 1 && stand)
                root.translation[k] += size * bounds.half[k] - first.half[k];
        }
        HATCH_TRY(append(&scenes[i], &root, (float)size, &made, arena, err));
        x += left;
    }
    *joined = made;
    return HATCH_OK;
}
