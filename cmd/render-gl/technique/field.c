#include "render-gl/technique/technique.h"

/* What --show field draws below the marks of render-gl/field.h. */
const struct technique technique_field = {
    .name = "field",
    .summary = "",
    .columns = COLUMNS_NONE,
    .stages = {.vertex = "gouraud.vert", .fragment = "gouraud.frag"},
    .defines = "",
    .pass_count = 1,
    .patches = PATCHES_UNSEEN,
    .pass_names = {"tone"},
};
