/* A plane below a scene, for shadows to fall on. */
#ifndef HATCH_SCENE_GROUND_H
#define HATCH_SCENE_GROUND_H

#include "scene/scene.h"

/* Adds a level square with texture coordinates, share of the scene's radius to each side of its middle, at the height
 * of the lowest point of its rest pose. It is a backdrop: the scene's bounds stay. */
enum hatch_status hatch_scene_add_ground(struct hatch_scene *scene, double share, struct hatch_arena *arena,
                                         struct hatch_arena *scratch, struct hatch_err *err) HATCH_MUST_USE;

#endif
