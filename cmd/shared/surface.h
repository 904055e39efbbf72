/* Surfaces as input of a command: what dirfield and lapped-param share. For commands that link gltf. */
#ifndef HATCH_CMD_SURFACE_H
#define HATCH_CMD_SURFACE_H

#include "shared/scene.h"
#include "surface/surface.h"

/* Makes a surface of each mesh of a scene that cmd_read_scene read with CMD_SCENE_AS_IS: entry i is that of
 * scene->meshes[i].mesh, which stays as it is. What was done to all of them together is one warning, and
 * none where nothing was, or where dirfield, before in the pipe, has said it. Meshes without any area are
 * taken out of the scene. path: the file, for messages. Memory: args->keep. Dies on failure, and when no
 * mesh is left. */
struct hatch_surface *cmd_make_surfaces(struct cmd_args *args, const char *path, struct hatch_scene *scene);

#endif
