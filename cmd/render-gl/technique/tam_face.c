#include "render-gl/technique/list.h"

/* Flat shading with a blend of two columns: the second of the approximations in Real-Time Hatching (Praun et al. 2001),
 * §5. */
const struct technique technique_tam_face = {
    .name = "tam-face",
    .summary = "two tones of the map blended per face: faces show, motion is smooth",
    .asset = &asset_columns,
    .features = TECHNIQUE_STROKES,
    .shading = {.stages = {.vertex = "corners/corner.vert",
                           .geometry = "corners/face.geom",
                           .fragment = "corners/face.frag"},
                .passes = {{.name = "strokes", .depth = FRAME_DEPTH_NEARER}}},
};
