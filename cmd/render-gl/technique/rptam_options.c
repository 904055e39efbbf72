/* Options of the technique rptam. */
#include "render-gl/technique/rptam.h"

struct rptam_options rptam_options = {.style = "ink", .layers_max = HATCH_RPTAM_LAYERS_MAX, .overlap = 0.3};

static const char *const fades[] = {"even", "paper", "weighted", NULL}; /* enum hatch_fade_law */
static const char *const fades_by[] = {"opacity", "size", NULL};
static const char *const loops[] = {"coverage", "brute", NULL};

const struct cmd_option rptam_option_table[] = {
    {0, "seeds", CMD_TEXT, 0, 0, "FILE", "+rptam: file of seed sets, made by seedgen (default: 4 sets of 64)",
     &rptam_options.seeds, NULL, NULL},
    {0, "layers", CMD_TEXT, 0, 0, "FILE", "+rptam: file with the strokes and tones of each layer (default: none)",
     &rptam_options.layers, NULL, NULL},
    {0, "style", CMD_TEXT, 0, 0, "STYLE", "rptam: drawing style of the strokes, a name or a file (default ink)",
     &rptam_options.style, NULL, NULL},
    {0, "stroke", CMD_PAIR, 0.5, 4096, "LxW", "+rptam: length and width of strokes in pixels (default: the style's)",
     rptam_options.stroke_px, NULL, NULL},
    {0, "stroke-ink", CMD_REAL, 0.01, 1, "X", "+rptam: darkness of a stroke (default: the style's)", &rptam_options.ink,
     NULL, NULL},
    {0, "stroke-turn", CMD_REAL, -360, 360, "DEGREES", "+rptam: turn every stroke about its middle (default 0)",
     &rptam_options.turn_deg, NULL, NULL},
    {0, "seed-tile", CMD_REAL, 8, 8192, "PX",
     "+rptam: side of the tile of seed points in pixels (default: from the strokes)", &rptam_options.tile_px, NULL,
     &rptam_options.tile_given},
    {0, "seed-layers", CMD_INT, 0, HATCH_RPTAM_LAYERS_MAX, "N", "+rptam: number of seed sets to draw (default 64: all)",
     &rptam_options.layers_max, NULL, NULL},
    {0, "fade", CMD_CHOICE, 0, 0, "LAW",
     "+rptam: how strokes fade with distance: even, weighted or paper (default even)", &rptam_options.fade, fades,
     NULL},
    {0, "fade-by", CMD_CHOICE, 0, 0, "WHAT",
     "+rptam: what of a fading stroke shrinks: opacity or size (default opacity)", &rptam_options.fade_by, fades_by,
     NULL},
    {0, "overlap", CMD_REAL, 0, 1, "X", "+rptam: strokes fade one by one, 0, to all at once, 1 (default 0.3)",
     &rptam_options.overlap, NULL, NULL},
    {0, "seed-loop", CMD_CHOICE, 0, 0, "HOW",
     "+rptam: use coverage lists, or brute: test all strokes (default coverage)", &rptam_options.loop, loops, NULL},
    {0},
};
