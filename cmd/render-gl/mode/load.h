/* Reads what a picture is made of from files. Where no status is returned they die with one line on what
 * is wrong. */
#ifndef RENDER_MODE_LOAD_H
#define RENDER_MODE_LOAD_H

#include "shared/cmd.h"
#include "scene/patches.h"

/* A glTF with its companions, or one mesh; count 0 is standard input; several are put in a row. ground: that of
 * hatch_scene_add_ground, or 0. Patches of lapped meshes are joined: *patches, of each of the scene's meshes. notes:
 * what to warn of is added. */
void load_scene(struct cmd_args *args, char *const *paths, uint32_t count, double ground, struct hatch_scene *scene,
                struct hatch_patch_mesh **patches, struct hatch_mesh_notes *notes);

/* HATCH_BAD_INPUT when a mesh has no texture coordinates, with the commands that give it some. */
enum hatch_status load_check_texcoords(const struct hatch_scene *scene, struct hatch_err *err) HATCH_MUST_USE;

#endif
