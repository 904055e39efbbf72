/* Surfaces as input of a command: shared by dirfield and lapped-param, which link the package gltf. */
#ifndef SHARED_SURFACE_H
#define SHARED_SURFACE_H

#include "shared/scene.h"
#include "surface/surface.h"

/* Makes the surface of each mesh of a scene, in args->keep. Repairs are reported in one warning, except those that
 * dirfield has reported already. Dies on failure, and when no mesh is left.
 *   path   of the scene, for messages
 *   scene  from cmd_read_scene with CMD_SCENE_AS_IS; meshes without area are removed, the others stay unchanged, except
 *          that those with faces given once for each side, which have one in the surface, become double-sided
 * Entry i of the result is the surface of scene->meshes[i].mesh. */
struct hatch_surface *cmd_make_surfaces(struct cmd_args *args, const char *path, struct hatch_scene *scene);

#endif
