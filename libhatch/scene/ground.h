/* A plane below a scene, for shadows to fall on. */
#ifndef HATCH_SCENE_GROUND_H
#define HATCH_SCENE_GROUND_H

#include "scene/pose.h"

/* Adds a horizontal square with texture coordinates at the height of the lowest point of some moments. Its node is a
 * backdrop, so the scene's bounds do not change.
 *   scene  its node and mesh arrays are replaced by longer ones in arena
 *   span   NULL: the rest pose
 *   share  half the square's side, in radii of the scene's bounds; over 0 */
enum hatch_status hatch_scene_add_ground(struct hatch_scene *scene, const struct hatch_pose_span *span, double share,
                                         struct hatch_arena *arena, struct hatch_arena *scratch,
                                         struct hatch_err *err) HATCH_MUST_USE;

#endif
