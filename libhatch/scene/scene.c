#include "scene/scene.h"

enum hatch_status hatch_scene_of_mesh(const struct hatch_mesh *mesh, struct hatch_arena *arena,
                                      struct hatch_scene *scene, struct hatch_err *err)
{
    struct hatch_scene made = {.mesh_count = 1, .node_count = 1};
    HATCH_TRY(HATCH_ALLOC(arena, &made.meshes, 1, err));
    HATCH_TRY(HATCH_ALLOC(arena, &made.nodes, 1, err));
    made.meshes[0] = (struct hatch_scene_mesh){
        .mesh = *mesh,
        .material = HATCH_NONE,
        .file_vertices = mesh->vertex_count,
        .had_texcoords = hatch_mesh_find(mesh, "TEXCOORD_0", 2) != NULL,
        .had_normals = hatch_mesh_find(mesh, "NORMAL", 3) != NULL,
        .normals_computed = !hatch_mesh_find(mesh, "NORMAL", 3),
    };
    made.nodes[0] = (struct hatch_node){
        .parent = HATCH_NONE,
        .rotation = {0, 0, 0, 1},
        .scale = {1, 1, 1},
        .mesh_count = 1,
        .skin = HATCH_NONE,
        .camera = HATCH_NONE,
        .light = HATCH_NONE,
    };
    *scene = made;
    return HATCH_OK;
}

void hatch_scene_renumber(struct hatch_scene *scene, const uint32_t *first)
{
    for (uint32_t n = 0; n < scene->node_count; n++) {
        struct hatch_node *node = &scene->nodes[n];
        uint32_t end = first[node->first_mesh + node->mesh_count];
        node->first_mesh = first[node->first_mesh];
        node->mesh_count = end - node->first_mesh;
    }
}

void hatch_scene_keep(struct hatch_scene *scene, const bool *kept, uint32_t *first)
{
    uint32_t count = 0;
    for (uint32_t m = 0; m < scene->mesh_count; m++) {
        first[m] = count;
        if (kept[m])
            scene->meshes[count++] = scene->meshes[m];
    }
    first[scene->mesh_count] = count;
    hatch_scene_renumber(scene, first);
    scene->mesh_count = count;
}
