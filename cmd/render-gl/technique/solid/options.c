/* Options of the technique solid. */
#include "render-gl/technique/solid/solid.h"

struct solid_options solid_options = {.files = "paper",
                                      .blend = HATCH_ZOOM_HISTOGRAM,
                                      .grain = 1,
                                      .bands = 5,
                                      .wobble_px = 3,
                                      .dry = 0.12,
                                      .darkening = 0.5,
                                      .paper_grain = 0.4,
                                      .border_px = 2.5};

static const char *const looks[] = {"plain", "binary", "watercolor", "collage", NULL};
static const char *const blends[] = {"linear", "contrast", "histogram", NULL}; /* enum hatch_zoom_blend */

const struct cmd_option solid_option_table[] = {
    {0, "solid", CMD_TEXT, 0, 0, "FILE",
     "+solid: textures of solidgen, styles of it, or pictures, with commas (default paper)", &solid_options.files, NULL,
     NULL},
    {0, "look", CMD_CHOICE, 0, 0, "LOOK", "+solid: plain, binary, watercolor or collage (default plain)",
     &solid_options.look, looks, NULL},
    {0, "inks", CMD_TEXT, 0, 0, "COLOURS",
     "+solid: inks of the materials in turn: colours with commas (default: --ink)", &solid_options.inks, NULL, NULL},
    {0, "solid-size", CMD_REAL, 4, 4096, "PX", "+solid: period of the texture in pixels (default: 2 per texel)",
     &solid_options.period_px, NULL, NULL},
    {0, "solid-turn", CMD_TEXT, 0, 0, "X,Y,Z",
     "+solid: turn the texture against the mesh, degrees around x, y, z (default: 0,0,0, or as suits)",
     &solid_options.turn, NULL, NULL},
    {0, "blend", CMD_CHOICE, 0, 0, "HOW",
     "+solid: how octaves are blended: linear, contrast or histogram (default histogram)", &solid_options.blend, blends,
     NULL},
    {0, "grain", CMD_REAL, 0, 1, "X", "+solid: strength of the texture (default 1)", &solid_options.grain, NULL, NULL},
    {0, "bands", CMD_INT, 1, 15, "N", "+solid: tones of watercolor and collage (default 5)", &solid_options.bands, NULL,
     NULL},
    {0, "wobble", CMD_REAL, 0, 32, "PX", "+solid: how far borders of tones wander, in pixels (default 3)",
     &solid_options.wobble_px, NULL, NULL},
    {0, "dry", CMD_REAL, 0, 1, "X", "+solid: watercolor: share of light paper that a dry brush skips (default 0.12)",
     &solid_options.dry, NULL, NULL},
    {0, "edge-darkening", CMD_REAL, 0, 1, "X", "+solid: watercolor: pigment that gathers at edges (default 0.5)",
     &solid_options.darkening, NULL, NULL},
    {0, "paper-grain", CMD_REAL, 0, 1, "X", "+solid: watercolor: how much the paper's grain shows (default 0.4)",
     &solid_options.paper_grain, NULL, NULL},
    {0, "border", CMD_REAL, 0, 16, "PX", "+solid: collage: width of the strips' white borders (default 2.5)",
     &solid_options.border_px, NULL, NULL},
    {0},
};
