#include "shared/needs/fit.h"

#include "shared/field.h"
#include "shared/surface.h"

void cmd_fit_meshes(struct cmd_args *args, const char *input, const char *path, const struct hatch_needs *needs,
                    struct hatch_scene *scene)
{
    const char *name = cmd_input_name(input);
    cmd_check_needs(args, path, name, needs, scene);
    cmd_coarsen(args, name, needs, CMD_FIELDS_KEPT, scene);
    const struct hatch_surface *surfaces = cmd_make_surfaces(args, input, scene);
    for (uint32_t i = 0; i < scene->mesh_count; i++)
        if (!hatch_mesh_find(&scene->meshes[i].mesh, "_HATCH_DIR", 4))
            cmd_add_field(args, name, &surfaces[i], &scene->meshes[i]);
    cmd_split_unseen(args, name, needs, scene);
}
