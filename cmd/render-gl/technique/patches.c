#include "render-gl/technique/technique.h"

/* What --show patches draws: the cover itself, as in real-time hatching §6. */
const struct technique technique_patches = {
    .name = "patches",
    .summary = "",
    .columns = COLUMNS_NONE,
    .stages = {.vertex = "patches.vert", .fragment = "patches.frag"},
    .defines = "",
    .pass_count = 1,
    .pass_names = {"tone"},
};
