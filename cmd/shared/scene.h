/* Scenes and meshes as input of a command: any format, any dirt. For commands that link gltf. */
#ifndef HATCH_CMD_SCENE_H
#define HATCH_CMD_SCENE_H

#include "shared/cmd.h"
#include "scene/scene.h"

enum cmd_scene_care {
    CMD_SCENE_AS_IS,  /* what the file holds, without a word but of what was skipped */
    CMD_SCENE_CLEANED /* PLY, OBJ, OFF and STL cleaned (hatch_mesh_clean), with warnings */
};

/* Reads a scene: glTF with its companions (those of standard input cannot be found), or a mesh file as
 * a scene of one node. Normals are those of the file, or glTF's flat ones. Memory: args->keep. Dies on
 * failure. */
void cmd_read_scene(struct cmd_args *args, const char *path, enum cmd_scene_care care, struct hatch_scene *scene);

/* The same without a word: what there is to warn of is added to notes, for commands that may have to end
 * with an error after all. */
void cmd_read_scene_noted(struct cmd_args *args, const char *path, enum cmd_scene_care care, struct hatch_scene *scene,
                          struct hatch_mesh_notes *notes);

/* Where a file has no normals, edges that turn by more than 60 degrees stay sharp. */
#define CMD_CREASE_RAD 1.0471975511965976f

/* A warning for each thing that a mesh's user should know, repaired or not. */
void cmd_warn_mesh(const char *name, const struct hatch_mesh_notes *notes);

#endif
