#include "render-gl/technique/technique.h"

/* One threshold and a steep ramp: Freudenberg's way, to compare with (Webb et al. 2002, §3.2). */
const struct technique technique_threshold_soft = {
    .name = "threshold-soft",
    .summary = "one threshold a texel and a steep ramp, as before there were seven",
    .columns = COLUMNS_THRESHOLDS,
    .stages = {.vertex = "gouraud.vert", .fragment = "threshold.frag"},
    .defines = "#define STROKES 1\n#define SOFT 1\n",
    .pixel_light = true,
    .pass_count = 1,
    .pass_names = {"strokes"},
};
