#include "render-gl/technique/list.h"
#include "render-gl/technique/shaded.h"

static const struct frame_shading shading = {
    .stages = {.vertex = "tam/tam.vert", .fragment = "tam/tam.frag"},
    .defines = "",
    .pixel_light = true,
    .pass_count = 1,
    .passes = {{.name = "strokes", .depth = FRAME_DEPTH_NEARER}},
};

/* The paper's single-pass 6-way blend (§5). */
const struct technique technique_tam = {
    .name = "tam",
    .summary = "six tones of the map, blended over each face",
    .asset = &asset_six_columns,
    .features = TECHNIQUE_STROKES | TECHNIQUE_PIXEL_LIGHT,
    .state_size = sizeof(struct shaded_state),
    .shading = &shading,
    .prepare = shaded_prepare,
    .draw = shaded_draw,
};
