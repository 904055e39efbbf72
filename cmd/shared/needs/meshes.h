/* Meshes that are no finer than views need, and the parts of them that no view shows: shared by commands that link the
 * package gltf. */
#ifndef SHARED_NEEDS_MESHES_H
#define SHARED_NEEDS_MESHES_H

#include "scene/scene.h"
#include "shared/needs/needs.h"

/* Checks that needs are those of a scene: that the boxes around them are the same, to within a cell of the regions.
 * Dies if not.
 *   path  of the needs
 *   name  of the scene, for messages */
void cmd_check_needs(struct cmd_args *args, const char *path, const char *name, const struct hatch_needs *needs,
                     const struct hatch_scene *scene);

/* Direction fields of meshes that may become coarser. */
enum cmd_fields {
    CMD_FIELDS_ANEW, /* are computed anew afterwards */
    CMD_FIELDS_KEPT  /* are kept: nodes with a mesh that has one stay as fine as they are */
};

/* Makes the meshes as coarse as the views allow, except those of nodes with computed flat normals, which coarser faces
 * would show. Meshes of formats other than glTF get normals where they have none, with creases of CMD_CREASE_RAD. What
 * no view shows becomes very coarse. Says how many faces are left out. Dies on failure.
 *   scene  in, out: new arrays are in args->keep */
void cmd_coarsen(struct cmd_args *args, const char *name, const struct hatch_needs *needs, enum cmd_fields fields,
                 struct hatch_scene *scene);

/* Divides each mesh into the part that views show and the rest, whose unseen_tolerance is set; says how many faces that
 * are. Each node draws both. Directions and texture coordinates are rounded when the scene is written. Dies on failure.
 *   scene  in, out: new arrays are in args->keep */
void cmd_split_unseen(struct cmd_args *args, const char *name, const struct hatch_needs *needs,
                      struct hatch_scene *scene);

/* Finds, per mesh, the most pixels that a unit of the scene's lengths covers on it; 0: no view shows it. Dies on
 * failure.
 *   px  out: one per mesh */
void cmd_mesh_px(struct cmd_args *args, const char *name, const struct hatch_needs *needs,
                 const struct hatch_scene *scene, double *px);

#endif
