#include "render-gl/technique/technique.h"

/* Not a choice of --technique: what --probe draws to see which tones and levels a picture uses. */
const struct technique technique_probe = {
    .name = "probe",
    .summary = "",
    .columns = COLUMNS_SIX,
    .stages = {.vertex = "probe.vert", .fragment = "probe.frag"},
    .defines = "",
    .pass_count = 1,
    .patches = PATCHES_COVER,
    .pass_names = {"probe"},
};
