/* Several scenes in one, side by side. */
#ifndef HATCH_SCENE_ROW_H
#define HATCH_SCENE_ROW_H

#include "scene/pose.h"

/* Puts scenes in a row from left to right, each as large as the first, a tenth of that apart: the places of
 * their boxes at rest count. The first one stays where it is. Nodes, materials, skins and all else are those
 * of the first, then those of the second; animations of one number play together in all. count: at least 1.
 * stand: their lowest points are level, else their middles. */
enum hatch_status hatch_scene_join_row(const struct hatch_scene *scenes, uint32_t count, bool stand,
                                       struct hatch_arena *arena, struct hatch_arena *scratch,
                                       struct hatch_scene *joined, struct hatch_err *err) HATCH_MUST_USE;

/* Where a scene's rest pose is. */
enum hatch_status hatch_scene_measure(const struct hatch_scene *scene, struct hatch_arena *scratch,
                                      struct hatch_bounds *bounds, struct hatch_err *err) HATCH_MUST_USE;

#endif
