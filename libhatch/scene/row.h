/* Joins scenes side by side, and turns a scene upright. */
#ifndef HATCH_SCENE_ROW_H
#define HATCH_SCENE_ROW_H

#include "scene/pose.h"

/* Joins scenes into one, in a row from left to right, spaced by their bounding boxes at rest. Each is scaled to the
 * radius of the first, with the lenses of its cameras and the reach of its lamps, and the gaps are a tenth of the first
 * one's diameter; the first scene does not move. Nodes, materials, skins and so on of the first scene come first, then
 * those of the second; animations with the same index become one. count   of scenes, at least 1 stand   true: align the
 * lowest points; false: align the centres joined  out: shares arrays with the scenes; other arrays are in arena */
enum hatch_status hatch_scene_join_row(const struct hatch_scene *scenes, uint32_t count, bool stand,
                                       struct hatch_arena *arena, struct hatch_arena *scratch,
                                       struct hatch_scene *joined, struct hatch_err *err) HATCH_MUST_USE;

enum hatch_up { HATCH_UP_X, HATCH_UP_Y, HATCH_UP_Z };

/* Turns a scene about its origin by a quarter, so that one of its axes points along y: z by turning about x, x about z.
 * Does nothing for HATCH_UP_Y. Nodes get a new first node as their root.
 *   scene  in, out: shares arrays with the scene given; other arrays are in arena */
enum hatch_status hatch_scene_turn_up(struct hatch_scene *scene, enum hatch_up up, struct hatch_arena *arena,
                                      struct hatch_err *err) HATCH_MUST_USE;

/* Computes the bounds of a scene over some moments.
 *   span  NULL: the rest pose */
enum hatch_status hatch_scene_measure(const struct hatch_scene *scene, const struct hatch_pose_span *span,
                                      struct hatch_arena *scratch, struct hatch_bounds *bounds,
                                      struct hatch_err *err) HATCH_MUST_USE;

#endif
