#include "scene/ground.h"

#include <string.h>

#include "shapes/shapes.h"
#include "scene/row.h"

#define FACES 2048u /* enough for lighting per vertex */

/* Turns the plane shape, which faces +z, to face +y, and places it below the scene. */
static void lay_down(struct hatch_mesh *mesh, const struct hatch_bounds *bounds, double half)
{
    float *position = hatch_mesh_find(mesh, "POSITION", 3), *normal = hatch_mesh_find(mesh, "NORMAL", 3);
    float *tangent = hatch_mesh_find(mesh, "TANGENT", 4);
    for (size_t v = 0; v < mesh->vertex_count; v++) {
        double x = (double)position[3 * v], y = (double)position[3 * v + 1];
        position[3 * v] = (float)(bounds->center[0] + half * x);
        position[3 * v + 1] = (float)(bounds->center[1] - bounds->half[1]);
        position[3 * v + 2] = (float)(bounds->center[2] - half * y);
        memcpy(&normal[3 * v], (const float[3]){0, 1, 0}, 3 * sizeof *normal);
        memcpy(&tangent[4 * v], (const float[3]){1, 0, 0}, 3 * sizeof *tangent);
    }
}

enum hatch_status hatch_scene_add_ground(struct hatch_scene *scene, const struct hatch_pose_span *span, double share,
                                         struct hatch_arena *arena, struct hatch_arena *scratch, struct hatch_err *err)
{
    const struct hatch_shape_options how = {.faces = FACES, .seed = 1};
    struct hatch_bounds bounds;
    struct hatch_node *nodes;
    struct hatch_scene_mesh *meshes;
    HATCH_TRY(HATCH_ALLOC(arena, &nodes, scene->node_count + (size_t)1, err));
    HATCH_TRY(HATCH_ALLOC(arena, &meshes, scene->mesh_count + (size_t)1, err));
    HATCH_TRY(hatch_scene_measure(scene, span, scratch, &bounds, err));
    if (scene->node_count)
        memcpy(nodes, scene->nodes, scene->node_count * sizeof *nodes);
    if (scene->mesh_count)
        memcpy(meshes, scene->meshes, scene->mesh_count * sizeof *meshes);
    struct hatch_scene_mesh *ground = &meshes[scene->mesh_count];
    *ground = (struct hatch_scene_mesh){.material = HATCH_NONE, .had_texcoords = true, .had_normals = true};
    HATCH_TRY(hatch_shape_make(HATCH_SHAPE_PLANE, &how, arena, scratch, &ground->mesh, err));
    ground->file_vertices = ground->mesh.vertex_count;
    lay_down(&ground->mesh, &bounds, share * bounds.radius);
    nodes[scene->node_count] = (struct hatch_node){.parent = HATCH_NONE,
                                                   .rotation = {0, 0, 0, 1},
                                                   .scale = {1, 1, 1},
                                                   .first_mesh = scene->mesh_count,
                                                   .mesh_count = 1,
                                                   .skin = HATCH_NONE,
                                                   .camera = HATCH_NONE,
                                                   .light = HATCH_NONE,
                                                   .backdrop = true};
    scene->nodes = nodes;
    scene->meshes = meshes;
    scene->node_count++;
    scene->mesh_count++;
    return HATCH_OK;
}
