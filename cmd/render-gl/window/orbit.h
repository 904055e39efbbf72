/* A view that a hand moves: around a point, nearer and further, sideways. */
#ifndef RENDER_ORBIT_H
#define RENDER_ORBIT_H

#include "render-gl/view.h"

#define ORBIT_NEAREST 0x1p-44
#define ORBIT_FARTHEST 1e3

struct orbit {
    struct view view;
    struct hatch_pair middle[3]; /* in the unit scene */
    double azimuth_rad, elevation_rad, distance;
};

/* Starts from a view, turning around what it looks at. */
void orbit_start(struct orbit *orbit, const struct view *view);

/* Turns by angles; elevation stops at the poles. */
void orbit_turn(struct orbit *orbit, double azimuth_rad, double elevation_rad);

/* Moves the middle sideways by shares of the picture's height. */
void orbit_pan(struct orbit *orbit, double right, double up);

/* From now on turns and zooms about what lies at a distance, over 0, in the picture's middle. */
void orbit_look_at(struct orbit *orbit, double distance);

/* Changes the distance, of an orthographic view half its height, by a factor over 0, between ORBIT_NEAREST and
 * ORBIT_FARTHEST. */
void orbit_zoom(struct orbit *orbit, double factor);

#endif
