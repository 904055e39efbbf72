#include "render-gl/technique/list.h"

/* Gouraud shading with the nearest column at each vertex: the third of the approximations in Real-Time Hatching (Praun
 * et al. 2001), §5. */
const struct technique technique_tam_gouraud = {
    .name = "tam-gouraud",
    .summary = "one tone of the map per vertex, blended over faces: tones pop in motion",
    .asset = &asset_columns,
    .features = TECHNIQUE_STROKES,
    .shading = {.stages = {.vertex = "corners/corner.vert",
                           .geometry = "corners/corners.geom",
                           .fragment = "corners/vertex_column.frag"},
                .passes = {{.name = "strokes", .depth = FRAME_DEPTH_NEARER}}},
};
