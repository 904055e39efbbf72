#include "render-gl/technique/technique.h"

/* Recursive procedural tonal art maps (Szécsi & Szirányi 2014, Algorithm 2). */
const struct technique technique_rptam = {
    .name = "rptam",
    .summary = "strokes at seeds that nest for ever: one width at every distance",
    .seeds = true,
    .stages = {.vertex = "rptam.vert", .fragment = "rptam.frag"},
    .defines = "",
    .pixel_light = true,
    .pass_count = 1,
    .pass_names = {"strokes"},
};
