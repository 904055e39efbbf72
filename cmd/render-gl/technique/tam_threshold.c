#include "render-gl/technique/technique.h"

/* The 6-way blend through clamp(8t − 3.5) (§5, tone thresholding). */
const struct technique technique_tam_threshold = {
    .name = "tam-threshold",
    .summary = "the same, its blended tone made black or white: strokes grow in length",
    .columns = COLUMNS_SIX,
    .stages = {.vertex = "tam.vert", .fragment = "tam.frag"},
    .defines = "#define THRESHOLD 1\n",
    .pixel_light = true,
    .samples = 16,
    .pass_count = 1,
    .pass_names = {"strokes"},
};
