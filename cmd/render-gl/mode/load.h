/* Loading scenes from files, and checks on them. */
#ifndef RENDER_MODE_LOAD_H
#define RENDER_MODE_LOAD_H

#include "shared/cmd.h"
#include "scene/patches.h"

/* Reads a glTF scene with its companion files, or a mesh. Exits with a message on failure.
 *   paths    count of them; several scenes are put in a row, none reads standard input
 *   ground   half the side of a ground plane to add, in the scene's radii; 0: none
 *   patches  out: one entry per mesh; those of lapped meshes hold their patches
 *   notes    in, out: adds causes for warnings */
void load_scene(struct cmd_args *args, char *const *paths, uint32_t count, double ground, struct hatch_scene *scene,
                struct hatch_patch_mesh **patches, struct hatch_mesh_notes *notes);

/* Fails with HATCH_BAD_INPUT if a mesh has no texture coordinates; the message names commands that make some. */
enum hatch_status load_check_texcoords(const struct hatch_scene *scene, struct hatch_err *err) HATCH_MUST_USE;

#endif
