/* Posing the scene on the GPU. */
#ifndef RENDER_SCENE_POSE_H
#define RENDER_SCENE_POSE_H

#include "render-gl/scene/scene.h"

/* Moves the items to a moment of an animation (HATCH_NONE: the rest pose). */
enum hatch_status scene_set_pose(struct scene *scene, uint32_t animation, double time_s, struct hatch_arena *scratch,
                                 struct hatch_err *err) HATCH_MUST_USE;

#endif
