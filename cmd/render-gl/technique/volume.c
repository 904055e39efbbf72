#include "render-gl/technique/list.h"
#include "render-gl/technique/shaded.h"

static const struct frame_shading shading = {
    .stages = {.vertex = "frame/tone.vert", .fragment = "volume/volume.frag"},
    .defines = "#define VOLUME 1\n#define STROKES 1\n",
    .pixel_light = true,
    .pass_count = 1,
    .passes = {{.name = "strokes", .depth = FRAME_DEPTH_NEARER}},
};

/* Webb et al., "Fine Tone Control in Hardware Hatching" (2002), §3.1. */
const struct technique technique_volume = {
    .name = "volume",
    .summary = "tone is the third coordinate of a 3D texture: strokes appear one by one",
    .asset = &asset_volume,
    .features = TECHNIQUE_STROKES | TECHNIQUE_PIXEL_LIGHT,
    .state_size = sizeof(struct shaded_state),
    .shading = &shading,
    .prepare = shaded_prepare,
    .draw = shaded_draw,
};
