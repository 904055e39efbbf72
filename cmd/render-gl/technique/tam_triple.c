#include "render-gl/technique/technique.h"

/* The faces are drawn black first; then only what lies at the same depth receives the sum. */
static void begin_pass(uint32_t pass)
{
    if (pass == 0)
        return;
    glEnable(GL_BLEND);
    glBlendFunc(GL_ONE, GL_ONE);
    glDepthFunc(GL_EQUAL);
    glDepthMask(GL_FALSE);
}

/* The paper's triple-pass 2-way blend (§5): each pass adds what one of a face's vertices gives, so that
 * two columns at a time are enough for any number of tones and for coloured ones. */
const struct technique technique_tam_triple = {
    .name = "tam-triple",
    .summary = "one pass a vertex of a face: any number of tones, coloured columns",
    .columns = COLUMNS_ARRAY,
    .stages = {.vertex = "corner.vert", .geometry = "corners.geom", .fragment = "triple.frag"},
    .defines = "",
    .pass_count = 4,
    .pass_names = {"black", "first", "second", "third"},
    .begin_pass = begin_pass,
};
