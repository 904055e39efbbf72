#include "render-gl/technique/technique.h"

/* Webb et al., "Fine Tone Control in Hardware Hatching" (2002), §3.1. */
const struct technique technique_volume = {
    .name = "volume",
    .summary = "tone is the third coordinate of a volume: strokes come one after the other, in colour if need be",
    .columns = COLUMNS_VOLUME,
    .stages = {.vertex = "gouraud.vert", .fragment = "volume.frag"},
    .defines = "#define VOLUME 1\n#define STROKES 1\n",
    .pixel_light = true,
    .pass_count = 1,
    .pass_names = {"strokes"},
};
