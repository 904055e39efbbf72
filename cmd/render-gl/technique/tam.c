#include "render-gl/technique/technique.h"

/* The paper's single-pass 6-way blend (§5). */
const struct technique technique_tam = {
    .name = "tam",
    .summary = "six columns at once, blended between tones and over faces",
    .columns = COLUMNS_SIX,
    .stages = {.vertex = "tam.vert", .fragment = "tam.frag"},
    .defines = "",
    .pixel_light = true,
    .pass_count = 1,
    .pass_names = {"strokes"},
};
