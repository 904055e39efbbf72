#include "render-gl/technique/technique.h"

/* Webb et al., "Fine Tone Control in Hardware Hatching" (2002), §3.2. */
const struct technique technique_threshold = {
    .name = "threshold",
    .summary = "seven thresholds a texel: no grey strokes, soft edges",
    .columns = COLUMNS_THRESHOLDS,
    .stages = {.vertex = "gouraud.vert", .fragment = "threshold.frag"},
    .defines = "#define STROKES 1\n",
    .pixel_light = true,
    .pass_count = 1,
    .pass_names = {"strokes"},
};
