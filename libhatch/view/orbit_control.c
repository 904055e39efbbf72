#include "view/orbit_control.h"

#define POLE_RAD 1.5607 /* π/2 - 0.01 */

/* Computes the view from the center, angles and distance. */
static void set_view(struct hatch_orbit *orbit)
{
    struct hatch_view *view = &orbit->view;
    double level = cos(orbit->elevation_rad);
    hatch_view_set_back(view, (const double[3]){level * sin(orbit->azimuth_rad), sin(orbit->elevation_rad),
                                                level * cos(orbit->azimuth_rad)});
    for (int k = 0; k < 3; k++) {
        struct hatch_pair eye = hatch_pair_add(orbit->center[k], hatch_pair_product(orbit->distance, view->back[k]));
        view->eye[k] = eye.high;
        view->eye_low[k] = eye.low;
    }
    view->pivot = orbit->distance;
}

void hatch_orbit_set_distance(struct hatch_orbit *orbit, double distance)
{
    const struct hatch_view *view = &orbit->view;
    orbit->distance = orbit->view.pivot = distance;
    for (int k = 0; k < 3; k++) {
        const struct hatch_pair eye = {view->eye[k], view->eye_low[k]};
        orbit->center[k] = hatch_pair_sub(eye, hatch_pair_product(distance, view->back[k]));
    }
}

void hatch_orbit_start(struct hatch_orbit *orbit, const struct hatch_view *view)
{
    orbit->view = *view;
    orbit->azimuth_rad = atan2(view->back[0], view->back[2]);
    orbit->elevation_rad = asin(fmax(-1, fmin(1, view->back[1])));
    hatch_orbit_set_distance(orbit, view->pivot);
}

void hatch_orbit_turn(struct hatch_orbit *orbit, double azimuth_rad, double elevation_rad)
{
    orbit->azimuth_rad += azimuth_rad;
    orbit->elevation_rad = fmax(-POLE_RAD, fmin(POLE_RAD, orbit->elevation_rad + elevation_rad));
    set_view(orbit);
}

void hatch_orbit_pan(struct hatch_orbit *orbit, double right, double up)
{
    const struct hatch_view *view = &orbit->view;
    double height = 2 * view->half_height * (view->orthographic ? 1 : orbit->distance);
    for (int k = 0; k < 3; k++) {
        double step = height * (right * view->right[k] + up * view->up[k]);
        orbit->center[k] = hatch_pair_add(orbit->center[k], hatch_pair_of(step));
    }
    set_view(orbit);
}

void hatch_orbit_zoom(struct hatch_orbit *orbit, double factor)
{
    double *size = orbit->view.orthographic ? &orbit->view.half_height : &orbit->distance;
    if (!(*size * factor > HATCH_ORBIT_NEAREST && *size * factor < HATCH_ORBIT_FARTHEST))
        return;
    *size *= factor;
    hatch_view_set_near_automatic(&orbit->view);
    orbit->view.finite = false;
    set_view(orbit);
}
