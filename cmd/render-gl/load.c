#include "render-gl/load.h"

#include "cmd_scene.h"

void load_scene(struct cmd_args *args, const char *path, struct hatch_scene *scene,
                struct patch_mesh **patches, struct hatch_mesh_notes *notes)
{
    struct hatch_err err;
    cmd_read_scene_noted(args, path, CMD_SCENE_CLEANED, scene, notes);
    for (uint32_t i = 0; i < scene->mesh_count; i++)
        cmd_check(hatch_mesh_add_normals(&args->keep, &args->scratch, &scene->meshes[i].mesh,
                                         CMD_CREASE_RAD, &err),
                  cmd_input_name(path), &err);
    cmd_check(patches_join(scene, &args->keep, &args->scratch, patches, &err), cmd_input_name(path),
              &err);
}

enum hatch_status load_check_texcoords(const struct hatch_scene *scene, struct hatch_err *err)
{
    for (uint32_t i = 0; i < scene->mesh_count; i++)
        if (!hatch_mesh_find(&scene->meshes[i].mesh, "TEXCOORD_0", 2))
            return hatch_fail(err, HATCH_BAD_INPUT,
                              "mesh %u has no texture coordinates for strokes to follow: "
                              "dirfield FILE | lapped-param | render-gl - --tam MAP gives it some",
                              i);
    return HATCH_OK;
}

enum hatch_status load_check_patches(const struct hatch_scene *scene, const struct patch_mesh *patches,
                                     struct hatch_err *err)
{
    for (uint32_t i = 0; i < scene->mesh_count; i++)
        if (patches[i].patch_count)
            return HATCH_OK;
    return hatch_fail(err, HATCH_BAD_INPUT,
                      "the scene has no patches: dirfield FILE | lapped-param makes some");
}
