#include "render-gl/technique/technique.h"

/* The second of §5's approximations: flat shading, blended between two columns. */
const struct technique technique_tam_face = {
    .name = "tam-face",
    .summary = "two columns blended a face: smooth in time, shows the faces",
    .columns = COLUMNS_ARRAY,
    .stages = {.vertex = "corner.vert", .geometry = "face.geom", .fragment = "face.frag"},
    .defines = "",
    .pass_count = 1,
    .pass_names = {"strokes"},
};
