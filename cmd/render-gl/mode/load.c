#include "render-gl/mode/load.h"

#include "shared/scene.h"
#include "scene/ground.h"
#include "scene/row.h"

static void load_row(struct cmd_args *args, char *const *paths, uint32_t count, bool stand, struct hatch_scene *scene,
                     struct hatch_mesh_notes *notes)
{
    struct hatch_err err;
    struct hatch_scene *scenes = HATCH_NEW(&args->keep, struct hatch_scene, count, &err);
    cmd_check(scenes ? HATCH_OK : HATCH_LIMIT, NULL, &err);
    for (uint32_t i = 0; i < count; i++)
        cmd_read_scene_silently(args, paths[i], CMD_SCENE_CLEANED, &scenes[i], notes);
    cmd_check(hatch_scene_join_row(scenes, count, stand, &args->keep, &args->scratch, scene, &err), NULL, &err);
}

/* Removes the faces of meshes whose base colour alone is below the alpha cutoff: no part of them is visible. */
static void drop_transparent(struct hatch_scene *scene, struct hatch_mesh_notes *notes)
{
    for (uint32_t i = 0; i < scene->mesh_count; i++) {
        struct hatch_scene_mesh *mesh = &scene->meshes[i];
        const struct hatch_material *material = mesh->material == HATCH_NONE ? NULL : &scene->materials[mesh->material];
        if (!material || !(material->base_color[3] < (material->outline ? 0.5f : material->alpha_cutoff)))
            continue;
        mesh->mesh.face_count = 0;
        notes->transparent_dropped++;
    }
}

void load_scene(struct cmd_args *args, char *const *paths, uint32_t count, double ground, struct hatch_scene *scene,
                struct hatch_patch_mesh **patches, struct hatch_mesh_notes *notes)
{
    const char *path = count ? paths[0] : NULL;
    struct hatch_err err;
    if (count > 1)
        load_row(args, paths, count, ground > 0, scene, notes);
    else
        cmd_read_scene_silently(args, path, CMD_SCENE_CLEANED, scene, notes);
    drop_transparent(scene, notes);
    if (ground > 0)
        cmd_check(hatch_scene_add_ground(scene, ground, &args->keep, &args->scratch, &err), cmd_input_name(path), &err);
    for (uint32_t i = 0; i < scene->mesh_count; i++)
        cmd_check(hatch_mesh_add_normals(&args->keep, &args->scratch, &scene->meshes[i].mesh, CMD_CREASE_RAD, &err),
                  cmd_input_name(path), &err);
    cmd_check(hatch_patches_join(scene, &args->keep, &args->scratch, patches, &err), cmd_input_name(path), &err);
}

enum hatch_status load_check_texcoords(const struct hatch_scene *scene, struct hatch_err *err)
{
    for (uint32_t i = 0; i < scene->mesh_count; i++)
        if (scene->meshes[i].mesh.face_count && !hatch_mesh_find(&scene->meshes[i].mesh, "TEXCOORD_0", 2))
            return hatch_fail(err, HATCH_BAD_INPUT,
                              "mesh %u has no texture coordinates, which strokes follow: "
                              "dirfield FILE | lapped-param -o NEW.glb makes some",
                              i);
    return HATCH_OK;
}
