/* Posing the scene on the GPU. */
#ifndef RENDER_SCENE_POSE_H
#define RENDER_SCENE_POSE_H

#include "render-gl/scene/scene.h"

/* Poses all items at a time of an animation, and uploads the vertices of deformed items.
 *   animation  index; HATCH_NONE: the rest pose
 *   time_s     time from the animation's start */
enum hatch_status scene_set_pose(struct scene *scene, uint32_t animation, double time_s, struct hatch_arena *scratch,
                                 struct hatch_err *err) HATCH_MUST_USE;

#endif
