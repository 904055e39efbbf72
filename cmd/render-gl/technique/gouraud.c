#include "render-gl/technique/list.h"

/* Draws the tone itself, which other techniques approximate by strokes. It is the reference for tone and for speed. */
const struct technique technique_gouraud = {
    .name = "gouraud",
    .summary = "the tone without strokes",
    .features = TECHNIQUE_PIXEL_LIGHT | TECHNIQUE_REFERENCE,
    .places = HATCH_NEAR_TEXCOORDS,
    .shading = {.stages = {.vertex = "frame/tone.vert", .fragment = "frame/tone.frag"},
                .pixel_light = true,
                .patches = FRAME_PATCHES_UNSEEN,
                .passes = {{.name = "tone", .depth = FRAME_DEPTH_NEARER}}},
};
