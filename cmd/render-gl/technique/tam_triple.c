#include "render-gl/technique/list.h"

/* The triple-pass 2-way blend of Real-Time Hatching (Praun et al. 2001), §5: each pass adds the share of one vertex of
 * every face. A pass reads two columns only, so that maps may have any number of tones, and may have colours. */
const struct technique technique_tam_triple = {
    .name = "tam-triple",
    .summary = "one pass per vertex of a face: maps with any number of tones, and colours",
    .asset = &asset_columns,
    .features = TECHNIQUE_STROKES | TECHNIQUE_ALL_COLUMNS,
    /* The first pass draws faces in black and writes depth; the others add where their depth is equal. */
    .shading = {.stages = {.vertex = "corners/corner.vert",
                           .geometry = "corners/corners.geom",
                           .fragment = "corners/triple.frag"},
                .passes = {{.name = "black", .depth = FRAME_DEPTH_NEARER},
                           {.name = "first", .blend = FRAME_BLEND_ADD, .depth = FRAME_DEPTH_EQUAL},
                           {.name = "second", .blend = FRAME_BLEND_ADD, .depth = FRAME_DEPTH_EQUAL},
                           {.name = "third", .blend = FRAME_BLEND_ADD, .depth = FRAME_DEPTH_EQUAL}}},
};
