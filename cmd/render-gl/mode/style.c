/* The style and the view of frames, as the options say. */
#include "math/angle.h"
#include "render-gl/mode/options.h"

#define AMBIENT 0.05 /* light from all directions, so that unlit parts are not all of one tone */

void options_style(const struct options *options, struct frame_style *style)
{
    *style = (struct frame_style){.inks = options->inks,
                                  .curve = {.low = options->tone_range[0],
                                            .high = options->tone_range[1],
                                            .gamma = options->tone_gamma,
                                            .ambient = AMBIENT,
                                            .specular = options->specular[0],
                                            .shininess = options->specular[1],
                                            .exposure = options->exposure},
                                  .light = {.replaces = options->light_given,
                                            .azimuth_rad = options->light_deg[0] * HATCH_RADIANS,
                                            .elevation_rad = options->light_deg[1] * HATCH_RADIANS},
                                  .anisotropy = (float)options->anisotropy,
                                  .hatch_turn_rad = options->hatch_turn_deg * HATCH_RADIANS,
                                  .hatch_scale = options->hatch_scale,
                                  .base_tone = options->base_tone,
                                  .base_color = look_options.colors,
                                  .pixel_light = options->pixel_light,
                                  .shadows = options->shadows,
                                  .shadow_edge = options->shadow_edge,
                                  .halo_px = options->halo_px};
}

struct hatch_view_choice options_view(const struct options *options)
{
    struct hatch_view_choice view = options->view;
    view.azimuth_rad = options->from_deg[0] * HATCH_RADIANS;
    view.elevation_rad = options->from_deg[1] * HATCH_RADIANS;
    view.fov_rad = options->fov_deg * HATCH_RADIANS;
    return view;
}
