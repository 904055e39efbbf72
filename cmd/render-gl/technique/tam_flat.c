#include "render-gl/technique/technique.h"

/* The first of §5's approximations: flat shading with a palette of columns. */
const struct technique technique_tam_flat = {
    .name = "tam-flat",
    .summary = "one column a face: pops between tones and shows the faces",
    .columns = COLUMNS_ARRAY,
    .stages = {.vertex = "corner.vert", .geometry = "face.geom", .fragment = "face.frag"},
    .defines = "#define NEAREST 1\n",
    .pass_count = 1,
    .pass_names = {"strokes"},
};
