#include "render-gl/technique/list.h"

/* The single-pass 6-way blend of Real-Time Hatching (Praun et al. 2001), §5. */
const struct technique technique_tam = {
    .name = "tam",
    .summary = "six tones of the map, blended over each face",
    .asset = &asset_six_columns,
    .features = TECHNIQUE_STROKES | TECHNIQUE_PIXEL_LIGHT,
    .places = HATCH_NEAR_TEXCOORDS,
    .shading = {.stages = {.vertex = "tam/tam.vert", .fragment = "tam/tam.frag"},
                .pixel_light = true,
                .passes = {{.name = "strokes", .depth = FRAME_DEPTH_NEARER}}},
};
