/* A view that a hand moves: around a point, nearer and further, sideways. */
#ifndef HATCH_VIEW_ORBIT_H
#define HATCH_VIEW_ORBIT_H

#include "view/view.h"

#define HATCH_ORBIT_NEAREST 0x1p-44
#define HATCH_ORBIT_FARTHEST 1e3

struct hatch_orbit {
    struct hatch_view view;
    struct hatch_pair middle[3]; /* in the unit scene */
    double azimuth_rad, elevation_rad, distance;
};

/* Starts from a view, turning around what it looks at. */
void hatch_orbit_start(struct hatch_orbit *orbit, const struct hatch_view *view);

/* Turns by angles; elevation stops at the poles. */
void hatch_orbit_turn(struct hatch_orbit *orbit, double azimuth_rad, double elevation_rad);

/* Moves the middle sideways by shares of the picture's height. */
void hatch_orbit_pan(struct hatch_orbit *orbit, double right, double up);

/* From now on turns and zooms about what lies at a distance, over 0, in the picture's middle. */
void hatch_orbit_look_at(struct hatch_orbit *orbit, double distance);

/* Changes the distance, of an orthographic view half its height, by a factor over 0, between HATCH_ORBIT_NEAREST and
 * HATCH_ORBIT_FARTHEST. */
void hatch_orbit_zoom(struct hatch_orbit *orbit, double factor);

#endif
