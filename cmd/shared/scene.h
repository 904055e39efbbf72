/* Scenes and meshes as input of a command, in all formats that hatch reads. A command that uses this links the package
 * gltf. */
#ifndef SHARED_SCENE_H
#define SHARED_SCENE_H

#include "shared/cmd.h"
#include "scene/scene.h"

enum cmd_scene_cleaning {
    CMD_SCENE_AS_IS,  /* as in the file; warns only of what was skipped */
    CMD_SCENE_CLEANED /* PLY, OBJ, OFF and STL are cleaned (hatch_mesh_clean), with warnings */
};

/* Crease angle of 60 degrees: edges with a larger angle stay sharp where a command computes normals. */
#define CMD_CREASE_RAD 1.0471975511965976f

/* Reads a scene: glTF with its companion files (which cannot be read when the glTF comes from standard input), or a
 * mesh file as a scene of one node. Normals are those of the file; a glTF without normals gets flat ones. Dies on
 * failure.
 *   path   NULL or "-": standard input
 *   scene  out, in args->keep */
void cmd_read_scene(struct cmd_args *args, const char *path, enum cmd_scene_cleaning cleaning,
                    struct hatch_scene *scene);

/* Reads a scene like cmd_read_scene, as it is, for a command that writes it again: also warns of the parts of the file
 * that the scene does not have.
 *   textures  whether it writes the textures */
void cmd_read_scene_to_write(struct cmd_args *args, const char *path, bool textures, struct hatch_scene *scene);

/* Files that a scene's file names and that were read with it, each once. */
struct cmd_companions {
    struct hatch_arena *arena; /* holds the list */
    struct cmd_companion {
        const char *path;
        size_t bytes;
        struct cmd_companion *next;
    } * first;
};

/* Reads a scene like cmd_read_scene, but counts defects in notes instead of warning of them. For commands that warn
 * later, since they may still fail.
 *   companions  in, out: the buffers and images of a glTF are added; may be NULL */
void cmd_read_scene_silently(struct cmd_args *args, const char *path, enum cmd_scene_cleaning cleaning,
                             struct hatch_scene *scene, struct hatch_mesh_notes *notes,
                             struct cmd_companions *companions);

/* Adds normals, with creases of CMD_CREASE_RAD, to the meshes of a scene that is no glTF where the file has none, so
 * that it looks the same when it is written as glTF, which has flat faces without normals. Dies on failure.
 *   scene  in, out: new arrays are in args->keep */
void cmd_add_normals(struct cmd_args *args, const char *name, struct hatch_scene *scene);

/* Warns of a mesh, of a format that does not define which axis points up, that seems to stand along z. */
void cmd_warn_up(const char *name, const struct hatch_scene *scene);

/* Warns of strokes on meshes, for a command that leaves them out. */
void cmd_warn_strokes(const char *name, const struct hatch_scene *scene);

/* Dies if the scene is output of lapped-param: each patch is a mesh of its own, and its texture coordinates are made
 * for the directions that it has. */
void cmd_refuse_lapped(const char *name, const struct hatch_scene *scene);

/* Prints one warning for each kind of defect in notes, repaired or not. */
void cmd_warn_mesh(const char *name, const struct hatch_mesh_notes *notes);

#endif
