#include "render-gl/technique/technique.h"

/* The third of §5's approximations: Gouraud shading with a palette of columns. */
const struct technique technique_tam_gouraud = {
    .name = "tam-gouraud",
    .summary = "one column a vertex, blended over faces: pops between tones",
    .columns = COLUMNS_ARRAY,
    .stages = {.vertex = "corner.vert", .geometry = "corners.geom", .fragment = "vertex_column.frag"},
    .defines = "",
    .pass_count = 1,
    .pass_names = {"strokes"},
};
