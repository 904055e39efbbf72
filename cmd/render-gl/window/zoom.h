/* Coming nearer to what the middle of a picture shows. */
#ifndef RENDER_ZOOM_H
#define RENDER_ZOOM_H

#include "render-gl/view.h"

/* Moves the view's eye along its axis until it is `factor` times nearer, or with a factor under 1 further, to the
 * face that the picture's middle shows; where it shows none, to what the camera looks at. moment: begin_s of its
 * animation counts. An orthographic view stays where it is and shows less. */
enum hatch_status zoom_view(struct pose *pose, const struct pose_span *moment, const struct bounds *bounds,
                            double factor, struct hatch_arena *scratch, struct view *view, struct hatch_err *err)
    HATCH_MUST_USE;

#endif
