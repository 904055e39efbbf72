#include "render-gl/technique/list.h"

/* Volumes: Webb et al., "Fine Tone Control in Hardware Hatching" (2002), §3.1. */
const struct technique technique_volume = {
    .name = "volume",
    .summary = "tone is the third coordinate of a 3D texture: strokes appear one by one",
    .asset = &asset_volume,
    .features = TECHNIQUE_STROKES | TECHNIQUE_PIXEL_LIGHT,
    .places = HATCH_NEAR_TEXCOORDS,
    .shading = {.stages = {.vertex = "frame/tone.vert", .fragment = "volume/volume.frag"},
                .defines = "#define VOLUME 1\n#define STROKES 1\n",
                .pixel_light = true,
                .passes = {{.name = "strokes", .depth = FRAME_DEPTH_NEARER}}},
};
