/* A plane below a scene, for shadows to fall on. */
#ifndef HATCH_SCENE_GROUND_H
#define HATCH_SCENE_GROUND_H

#include "scene/scene.h"

/* Adds a horizontal square with texture coordinates at the height of the lowest point of the rest pose. Its node is a
 * backdrop, so the scene's bounds do not change.
 *   scene  its node and mesh arrays are replaced by longer ones in arena
 *   share  half the square's side, in radii of the scene's bounds; over 0 */
enum hatch_status hatch_scene_add_ground(struct hatch_scene *scene, double share, struct hatch_arena *arena,
                                         struct hatch_arena *scratch, struct hatch_err *err) HATCH_MUST_USE;

#endif
