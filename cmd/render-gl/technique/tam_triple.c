#include "render-gl/technique/list.h"
#include "render-gl/technique/shaded.h"

/* The faces are drawn black first; then only what lies at the same depth receives the sum. */
static const struct frame_shading shading = {
    .stages = {.vertex = "corners/corner.vert", .geometry = "corners/corners.geom", .fragment = "corners/triple.frag"},
    .defines = "",
    .pass_count = 4,
    .passes = {{.name = "black", .depth = FRAME_DEPTH_NEARER},
               {.name = "first", .blend = FRAME_BLEND_ADD, .depth = FRAME_DEPTH_EQUAL},
               {.name = "second", .blend = FRAME_BLEND_ADD, .depth = FRAME_DEPTH_EQUAL},
               {.name = "third", .blend = FRAME_BLEND_ADD, .depth = FRAME_DEPTH_EQUAL}},
};

/* The paper's triple-pass 2-way blend (§5): each pass adds the share of one of a face's vertices, so that two columns
 * at a time are enough for any number of tones and for coloured ones. */
const struct technique technique_tam_triple = {
    .name = "tam-triple",
    .summary = "one pass a vertex of a face: any number of tones, coloured columns",
    .asset = &asset_columns,
    .features = TECHNIQUE_STROKES | TECHNIQUE_ALL_COLUMNS,
    .state_size = sizeof(struct shaded_state),
    .shading = &shading,
    .prepare = shaded_prepare,
    .draw = shaded_draw,
};
