/* Auto exposure: the factor for the scene's lights at which the brightest twentieth of the lit surface is white.
 * Backdrops do not count. */
#ifndef HATCH_VIEW_EXPOSURE_H
#define HATCH_VIEW_EXPOSURE_H

#include "view/light.h"
#include "scene/unit_scene.h"

/* Computes the exposure from the diffuse light of the scene's lights, without shadows: the least that some moment
 * needs. A vertex counts with a third of the area of the faces around it; where light is computed per pixel and a lamp
 * is among the lights, large faces count part by part. A light counts only through what it lights: strong lights that
 * are out of range or turned away have no influence. Backs of faces that are visible from both sides count if no front
 * is lit.
 *   scene      in, out: where it has lights, it is left at the last moment
 *   span       NULL: the present pose
 *   view       orients the key light of a scene without lights
 *   per_pixel  light is computed per pixel, not per vertex
 *   exposure   out: over 0; 1 if nothing is lit at any moment */
enum hatch_status hatch_auto_exposure(struct hatch_unit_scene *scene, const struct hatch_pose_span *span,
                                      const struct hatch_view *view, bool per_pixel, struct hatch_arena *scratch,
                                      double *exposure, struct hatch_err *err) HATCH_MUST_USE;

#endif
