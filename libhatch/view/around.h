/* A set of views of one scene, from one side or from all sides, and how large lengths are in their pictures. */
#ifndef HATCH_VIEW_AROUND_H
#define HATCH_VIEW_AROUND_H

#include "view/view.h"

#define HATCH_VIEWS_AROUND 24u /* views from all sides */

struct hatch_view_set {
    const struct hatch_bounds *bounds;
    uint32_t count;
    struct hatch_view *views;
    double width_px, height_px; /* of the pictures */
};

/* Makes framed views, each zoomed by a factor (hatch_view_zoom).
 *   choice  FRAMED; its azimuth and elevation are used if it is the only view
 *   alone   true: the chosen view; false: HATCH_VIEWS_AROUND views, whose directions are spread evenly over the sphere
 *   pose    in, out: at rest on return
 *   bounds  of the scene; kept by reference
 *   size    width and height of the pictures in pixels
 *   set     out: its array is in arena */
enum hatch_status hatch_views_make(const struct hatch_view_choice *choice, bool alone, double zoom,
                                   struct hatch_pose *pose, const struct hatch_bounds *bounds, const double size[2],
                                   struct hatch_arena *arena, struct hatch_arena *scratch, struct hatch_view_set *set,
                                   struct hatch_err *err) HATCH_MUST_USE;

/* Returns the largest number of pixels that a length of 1 covers at a point of the world, in any of the views. */
double hatch_views_pixels(const struct hatch_view_set *set, const double world[3]);

#endif
