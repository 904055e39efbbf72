#include "render-gl/technique/list.h"

/* One threshold and a steep ramp (Freudenberg's method, described in Webb et al. 2002, §3.2), for comparison. */
const struct technique technique_threshold_soft = {
    .name = "threshold-soft",
    .summary = "one threshold per texel with a steep ramp, for comparison",
    .asset = &asset_thresholds,
    .features = TECHNIQUE_STROKES | TECHNIQUE_PIXEL_LIGHT,
    .places = HATCH_NEAR_TEXCOORDS,
    .shading = {.stages = {.vertex = "frame/tone.vert", .fragment = "threshold/threshold.frag"},
                .defines = "#define STROKES 1\n#define SOFT 1\n",
                .pixel_light = true,
                .passes = {{.name = "strokes", .depth = FRAME_DEPTH_NEARER}}},
};
