#include "render-gl/technique/technique.h"

/* The tone that the other techniques draw with strokes: the reference for tone and for speed. */
const struct technique technique_gouraud = {
    .name = "gouraud",
    .summary = "the tone alone, without strokes",
    .columns = COLUMNS_NONE,
    .stages = {.vertex = "gouraud.vert", .fragment = "gouraud.frag"},
    .defines = "",
    .pixel_light = true,
    .pass_count = 1,
    .patches = PATCHES_UNSEEN,
    .pass_names = {"tone"},
};
