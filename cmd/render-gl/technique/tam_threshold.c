#include "render-gl/technique/list.h"

/* The 6-way blend, whose result t (reflectance) is replaced by clamp(8t − 3.5, 0, 1): tone thresholding in Real-Time
 * Hatching (Praun et al. 2001), §5. */
const struct technique technique_tam_threshold = {
    .name = "tam-threshold",
    .summary = "tam with strokes made black or white: they grow in length, not in darkness",
    .asset = &asset_six_columns,
    .features = TECHNIQUE_STROKES | TECHNIQUE_PIXEL_LIGHT,
    .places = HATCH_NEAR_TEXCOORDS,
    .samples = 16,
    .shading = {.stages = {.vertex = "tam/tam.vert", .fragment = "tam/tam.frag"},
                .defines = "#define THRESHOLD 1\n",
                .pixel_light = true,
                .passes = {{.name = "strokes", .depth = FRAME_DEPTH_NEARER}}},
};
