/* Makes the meshes of a scene as coarse as its views allow. */
#ifndef HATCH_COARSE_SCENE_H
#define HATCH_COARSE_SCENE_H

#include "scene/pose.h"
#include "view/around.h"

/* Makes the meshes of a scene coarser. The meshes of one node are one surface, whose borders stay closed. Meshes that
 * no node draws are kept.
 *   pose         at rest; in, out: its scratch members
 *   views        of the scene at rest
 *   error_px     how far the surface may move, in pixels of the views; a mesh that has no size at rest counts as large
 * as hatch_scene_find_extent finds share        per vertex of all meshes of all nodes, in the order of
 * hatch_scene_flatten: the share of error_px that is allowed there; NULL: 1 meshes       out: one mesh per mesh of the
 * scene, in arena or the scene's */
enum hatch_status hatch_coarse_scene(struct hatch_pose *pose, const struct hatch_view_set *views, double error_px,
                                     const float *share, struct hatch_arena *arena, struct hatch_arena *scratch,
                                     struct hatch_mesh *meshes, struct hatch_err *err) HATCH_MUST_USE;

#endif
