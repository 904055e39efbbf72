/* Interactive camera: turns around a point, zooms and pans. */
#ifndef HATCH_VIEW_ORBIT_CONTROL_H
#define HATCH_VIEW_ORBIT_CONTROL_H

#include "view/view.h"

/* Limits of the distance and of the half height in zooming, in units of the unit scene. */
#define HATCH_ORBIT_NEAREST 0x1p-44
#define HATCH_ORBIT_FARTHEST 1e3

struct hatch_orbit {
    struct hatch_view view;
    struct hatch_pair center[3];                 /* the point that the view turns around, in the unit scene */
    double azimuth_rad, elevation_rad, distance; /* position of the eye relative to center */
};

/* Starts from a view. The center is in the middle of the picture, at the distance of the view's pivot. */
void hatch_orbit_start(struct hatch_orbit *orbit, const struct hatch_view *view);

/* Turns the view around the center; the elevation is clamped just short of the poles. */
void hatch_orbit_turn(struct hatch_orbit *orbit, double azimuth_rad, double elevation_rad);

/* Moves the center and the eye sideways.
 *   right, up  as shares of the picture's height */
void hatch_orbit_pan(struct hatch_orbit *orbit, double right, double up);

/* Moves the center along the view axis without changing the picture.
 *   distance  of the new center from the eye, over 0 */
void hatch_orbit_set_distance(struct hatch_orbit *orbit, double distance);

/* Multiplies the distance from the center by a factor; for an orthographic view, half the picture's height instead.
 * Does nothing if the result would be outside HATCH_ORBIT_NEAREST .. HATCH_ORBIT_FARTHEST.
 *   factor  over 0 */
void hatch_orbit_zoom(struct hatch_orbit *orbit, double factor);

#endif
