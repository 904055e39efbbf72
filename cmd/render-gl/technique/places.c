#include "render-gl/technique/technique.h"

/* Not a choice of --technique: where fragments lie among the seeds, for tests and measurements. */
const struct technique technique_places = {
    .name = "places",
    .summary = "",
    .seeds = true,
    .stages = {.vertex = "rptam.vert", .fragment = "places.frag"},
    .defines = "",
    .pass_count = 1,
    .patches = PATCHES_COVER,
    .pass_names = {"places"},
};
