/* A light meter: the exposure at which a scene's own lights just reach white. */
#ifndef RENDER_METER_H
#define RENDER_METER_H

#include "render-gl/frame.h"
#include "render-gl/scene.h"

/* Measures what the scene's lights give to its vertices at the present pose, and sets *exposure so that
 * the brightest twentieth of the lit ones is white. Lamps inside of things, beyond their range or behind
 * their cones count for what they light, not for their strength. 1 where nothing is lit. */
enum hatch_status meter_exposure(const struct gpu_scene *scene, const struct hatch_view *view,
                                 struct hatch_arena *scratch, double *exposure, struct hatch_err *err) HATCH_MUST_USE;

#endif
