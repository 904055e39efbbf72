#include "render-gl/technique/list.h"

/* Flat shading with the nearest column: the first of the approximations in Real-Time Hatching (Praun et al. 2001), §5.
 */
const struct technique technique_tam_flat = {
    .name = "tam-flat",
    .summary = "one tone of the map per face: faces show, and tones pop in motion",
    .asset = &asset_columns,
    .features = TECHNIQUE_STROKES,
    .shading = {.stages = {.vertex = "corners/corner.vert",
                           .geometry = "corners/face.geom",
                           .fragment = "corners/face.frag"},
                .defines = "#define NEAREST 1\n",
                .passes = {{.name = "strokes", .depth = FRAME_DEPTH_NEARER}}},
};
