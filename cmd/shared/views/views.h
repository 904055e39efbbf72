/* The views for which a command computes: of a scene at rest, framed, from one side or from all sides. */
#ifndef SHARED_VIEWS_VIEWS_H
#define SHARED_VIEWS_VIEWS_H

#include "shared/cmd.h"
#include "view/around.h"

/* Values of the options --size, --from, --fov and --zoom; from_deg is out of range where it is not given. */
struct cmd_view_options {
    double size_px[2], from_deg[2], fov_deg, zoom;
    bool alone; /* --from was given: one view */
};

#define CMD_VIEW_OPTIONS                                                                                               \
    {                                                                                                                  \
        .size_px = {1280, 720}, .from_deg = {-1000, -1000}, .fov_deg = 30, .zoom = 1                                   \
    }

/* Poses a scene at rest and makes its views, in args->keep. Dies on failure.
 *   pose, bounds, views  out */
void cmd_make_views(struct cmd_args *args, const char *name, const struct hatch_scene *scene,
                    const struct cmd_view_options *options, struct hatch_pose *pose, struct hatch_bounds *bounds,
                    struct hatch_view_set *views);

#endif
