#include "shared/views/views.h"

#include "math/angle.h"

void cmd_make_views(struct cmd_args *args, const char *name, const struct hatch_scene *scene,
                    const struct cmd_view_options *options, struct hatch_pose *pose, struct hatch_bounds *bounds,
                    struct hatch_view_set *views)
{
    const struct hatch_pose_span rest = {.animation = HATCH_NONE, .moments = 1};
    const struct hatch_view_choice choice = {.kind = HATCH_VIEW_FRAMED,
                                             .azimuth_rad = options->alone ? options->from_deg[0] * HATCH_RADIANS : 0,
                                             .elevation_rad = options->alone ? options->from_deg[1] * HATCH_RADIANS : 0,
                                             .fov_rad = options->fov_deg * HATCH_RADIANS};
    struct hatch_err err;
    cmd_check(hatch_pose_make(scene, &args->keep, pose, &err), name, &err);
    cmd_check(hatch_pose_bounds(pose, &rest, &args->scratch, bounds, &err), name, &err);
    cmd_check(hatch_views_make(&choice, options->alone, options->zoom, pose, bounds, options->size_px, &args->keep,
                               &args->scratch, views, &err),
              name, &err);
}
