/* Options of looks. */
#include "render-gl/look/look.h"

struct look_options look_options = {.files = "paper",
                                    .blend = -1,
                                    .grain = 1,
                                    .bands = 5,
                                    .wobble_px = 3,
                                    .dry = 0.12,
                                    .wet = 0.5,
                                    .darkening = 0.5,
                                    .paper_grain = 0.4,
                                    .border_px = 2.5};

static const char *const looks[] = {"plain", "binary", "watercolor", "collage", NULL};
static const char *const blends[] = {"linear", "contrast", "histogram", "union", NULL}; /* enum hatch_zoom_blend */

const struct cmd_option look_option_table[] = {
    {0, "solid", CMD_TEXT, 0, 0, "FILE",
     "+looks: textures of solidgen, styles of it, or pictures, with commas (default paper)", &look_options.files, NULL,
     NULL},
    {0, "look", CMD_CHOICE, 0, 0, "LOOK", "+watercolor; or plain, binary or collage, of solid textures (default plain)",
     &look_options.kind, looks, NULL},
    {0, "inks", CMD_TEXT, 0, 0, "COLOURS",
     "+looks: inks of the materials in turn: colours with commas (default: --ink)", &look_options.inks, NULL, NULL},
    {0, "texture-color", CMD_FLAG, 0, 0, NULL, "+looks: paint the colours and textures of materials; ink shades them",
     &look_options.colors, NULL, NULL},
    {0, "solid-size", CMD_REAL, 4, 4096, "PX", "+looks: period of the texture in pixels (default: 2 per texel)",
     &look_options.period_px, NULL, NULL},
    {0, "solid-turn", CMD_TEXT, 0, 0, "X,Y,Z",
     "+solid: turn the texture against the mesh, degrees around x, y, z (default: 0,0,0, or as suits)",
     &look_options.turn, NULL, NULL},
    {0, "blend", CMD_CHOICE, 0, 0, "HOW",
     "+looks: how octaves are blended: linear, contrast, histogram or union (default: as suits)", &look_options.blend,
     blends, NULL},
    {0, "grain", CMD_REAL, 0, 1, "X", "+looks: strength of the texture (default 1)", &look_options.grain, NULL, NULL},
    {0, "bands", CMD_INT, 1, 15, "N", "+looks: tones of watercolor and collage (default 5)", &look_options.bands, NULL,
     NULL},
    {0, "wobble", CMD_REAL, 0, 32, "PX", "+looks: how far borders of tones wander, in pixels (default 3)",
     &look_options.wobble_px, NULL, NULL},
    {0, "dry", CMD_REAL, 0, 1, "X", "+watercolor: share of light paper that a dry brush skips (default 0.12)",
     &look_options.dry, NULL, NULL},
    {0, "wet", CMD_REAL, 0, 1, "X", "+watercolor: ink that runs into lighter washes (default 0.5)", &look_options.wet,
     NULL, NULL},
    {0, "edge-darkening", CMD_REAL, 0, 1, "X", "+watercolor: pigment that gathers at edges (default 0.5)",
     &look_options.darkening, NULL, NULL},
    {0, "paper-grain", CMD_REAL, 0, 1, "X", "+watercolor: how much the paper's grain shows (default 0.4)",
     &look_options.paper_grain, NULL, NULL},
    {0, "border", CMD_REAL, 0, 16, "PX", "+collage: width of the strips' white borders (default 2.5)",
     &look_options.border_px, NULL, NULL},
    {0},
};
