/* Lights of a posed scene, in the unit scene, as floats that shaders read. */
#ifndef HATCH_VIEW_LIGHT_H
#define HATCH_VIEW_LIGHT_H

#include "view/view.h"

#define HATCH_LIGHTS_MAX 64u

/* The light that is used where the scene has none, or instead of the scene's. */
struct hatch_key_light {
    bool replaces;                     /* the scene's lights do not count */
    double azimuth_rad, elevation_rad; /* direction to the light, seen from the camera: 0 0 is from behind it */
};

/* 48 bytes, as a GLSL struct of three vec4. */
struct hatch_unit_light {
    float position[4];  /* xyz in the unit scene; w: 0 directional, 1 point or spot */
    float direction[4]; /* unit vector to the light (directional) or along the spot; w: strength */
    float cone[4];      /* scale and offset of the spot's edge; 1/range²; least distance² that counts */
};

/* Fills the lights of the scene at its pose, the first HATCH_LIGHTS_MAX of them, or the key light alone.
 *   exposure  factor for the scene's lights, over 0; the key light has strength 1
 *   lights    out: HATCH_LIGHTS_MAX entries
 * Returns their number, at least 1. */
uint32_t hatch_lights_at(const struct hatch_pose *pose, const struct hatch_bounds *bounds,
                         const struct hatch_view *view, const struct hatch_key_light *key, double exposure,
                         struct hatch_unit_light *lights);

/* Whether the key light is the only one. */
bool hatch_lights_are_key_alone(const struct hatch_scene *scene, const struct hatch_key_light *key);

/* How many of the scene's lights are more than HATCH_LIGHTS_MAX. */
uint32_t hatch_lights_left_out(const struct hatch_scene *scene);

/* The strength of the strongest of the scene's lights, in the unit scene; 0 without lights. */
double hatch_lights_strongest(const struct hatch_pose *pose, const struct hatch_bounds *bounds);

#endif
