#include "render-gl/technique/list.h"
#include "render-gl/technique/shaded.h"

static const struct frame_shading shading = {
    .stages = {.vertex = "corners/corner.vert", .geometry = "corners/face.geom", .fragment = "corners/face.frag"},
    .defines = "",
    .pass_count = 1,
    .passes = {{.name = "strokes", .depth = FRAME_DEPTH_NEARER}},
};

/* The second of §5's approximations: flat shading, blended between two columns. */
const struct technique technique_tam_face = {
    .name = "tam-face",
    .summary = "two tones of the map blended per face: faces show, motion is smooth",
    .asset = &asset_columns,
    .features = TECHNIQUE_STROKES,
    .state_size = sizeof(struct shaded_state),
    .shading = &shading,
    .prepare = shaded_prepare,
    .draw = shaded_draw,
};
