#include "render-gl/technique/list.h"

/* Threshold textures: Webb et al., "Fine Tone Control in Hardware Hatching" (2002), §3.2. */
const struct technique technique_threshold = {
    .name = "threshold",
    .summary = "texels darken at thresholds of tone: black strokes with soft edges",
    .asset = &asset_thresholds,
    .features = TECHNIQUE_STROKES | TECHNIQUE_PIXEL_LIGHT,
    .places = HATCH_NEAR_TEXCOORDS,
    .shading = {.stages = {.vertex = "frame/tone.vert", .fragment = "threshold/threshold.frag"},
                .defines = "#define STROKES 1\n",
                .pixel_light = true,
                .passes = {{.name = "strokes", .depth = FRAME_DEPTH_NEARER}}},
};
