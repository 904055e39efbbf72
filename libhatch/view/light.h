/* Lights of a posed scene in the unit scene, as floats for shaders. */
#ifndef HATCH_VIEW_LIGHT_H
#define HATCH_VIEW_LIGHT_H

#include "view/view.h"

#define HATCH_LIGHTS_MAX 64u

/* A directional light that is fixed to the camera, for scenes without lights. */
struct hatch_key_light {
    bool replaces;                     /* used also if the scene has lights, in place of them */
    double azimuth_rad, elevation_rad; /* where it comes from, relative to the camera; 0 0: from the camera */
};

/* A light as a GLSL struct of three vec4, 48 bytes. */
struct hatch_unit_light {
    float position[4];  /* xyz: unit scene; w: 0 directional, 1 point or spot */
    float direction[4]; /* xyz: unit vector to the light (directional) or along the axis of the spot; w: strength */
    float cone[4];      /* xy: scale and offset of the cosine, for the falloff of a spot; z: 1/range², or 0; w: squared
                           distances are raised to this before dividing by them */
};

/* Computes the lights of a posed scene, up to HATCH_LIGHTS_MAX, or the key light alone.
 *   exposure  factor for the scene's lights, over 0; the key light has strength 1
 *   lights    out: HATCH_LIGHTS_MAX entries
 * Returns their number, at least 1. */
uint32_t hatch_lights_fill(const struct hatch_pose *pose, const struct hatch_bounds *bounds,
                           const struct hatch_view *view, const struct hatch_key_light *key, double exposure,
                           struct hatch_unit_light *lights);

/* Returns whether hatch_lights_fill uses the key light. */
bool hatch_lights_are_key_alone(const struct hatch_scene *scene, const struct hatch_key_light *key);

/* Returns the number of lights beyond HATCH_LIGHTS_MAX, which are not drawn. */
uint32_t hatch_lights_left_out(const struct hatch_scene *scene);

/* Returns the largest strength among the scene's lights, in the unit scene; 0 without lights. */
double hatch_lights_strongest(const struct hatch_pose *pose, const struct hatch_bounds *bounds);

#endif
