/* Auto exposure: the factor at which a scene's own lights just reach white. */
#ifndef HATCH_VIEW_EXPOSURE_H
#define HATCH_VIEW_EXPOSURE_H

#include "view/light.h"
#include "scene/unit_scene.h"

/* Computes the light that the scene's lamps give to its vertices at the present pose, and the exposure at which the
 * brightest twentieth of the lit vertices is white. Lamps inside of things, beyond their range or behind their cones
 * count by the vertices that they light, not by their strength.
 *   view      orients the key light of a scene without lamps
 *   exposure  out: over 0; 1 where no vertex is lit */
enum hatch_status hatch_auto_exposure(const struct hatch_unit_scene *scene, const struct hatch_view *view,
                                      struct hatch_arena *scratch, double *exposure,
                                      struct hatch_err *err) HATCH_MUST_USE;

#endif
