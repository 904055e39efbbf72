/* Options of strokes at seed points. */
#include "render-gl/technique/rptam.h"

struct rptam_options rptam_options = {.style = "ink", .layers_max = HATCH_RPTAM_LAYERS_MAX, .overlap = 0.3};

static const char *const fades[] = {"even", "paper", "weighted", NULL}; /* enum hatch_fade_law */
static const char *const fades_by[] = {"opacity", "size", NULL};
static const char *const loops[] = {"coverage", "brute", NULL};

const struct cmd_option rptam_option_table[] = {
    {0, "seeds", CMD_TEXT, 0, 0, "FILE", "rptam: seed sets, as seedgen writes them (default: 4 of 64)",
     &rptam_options.seeds, NULL, NULL},
    {0, "layers", CMD_TEXT, 0, 0, "FILE", "+rptam: strokes and tones of each layer, a line each", &rptam_options.layers,
     NULL, NULL},
    {0, "style", CMD_TEXT, 0, 0, "STYLE", "rptam: the drawing style of the strokes (default ink)", &rptam_options.style,
     NULL, NULL},
    {0, "stroke", CMD_PAIR, 0.5, 4096, "LxW", "+rptam: length and width in pixels (default: the style's)",
     rptam_options.stroke_px, NULL, NULL},
    {0, "stroke-ink", CMD_REAL, 0.01, 1, "X", "+rptam: how dark a stroke is (default: the style's)", &rptam_options.ink,
     NULL, NULL},
    {0, "stroke-turn", CMD_REAL, -360, 360, "DEGREES", "+rptam: turn the strokes about their middles (default 0)",
     &rptam_options.turn_deg, NULL, NULL},
    {0, "seed-tile", CMD_REAL, 8, 8192, "PX", "+rptam: side of a set's tile (default: to suit the strokes)",
     &rptam_options.tile_px, NULL, &rptam_options.tile_given},
    {0, "seed-layers", CMD_INT, 0, HATCH_RPTAM_LAYERS_MAX, "N", "+rptam: draw no more than the first N sets",
     &rptam_options.layers_max, NULL, NULL},
    {0, "fade", CMD_CHOICE, 0, 0, "LAW", "+rptam: even (default) or weighted, which keep the tone, or paper",
     &rptam_options.fade, fades, NULL},
    {0, "fade-by", CMD_CHOICE, 0, 0, "WHAT", "+rptam: opacity (default) or size", &rptam_options.fade_by, fades_by,
     NULL},
    {0, "overlap", CMD_REAL, 0, 1, "X", "+rptam: strokes fade together, 1, or one by one, 0 (default 0.3)",
     &rptam_options.overlap, NULL, NULL},
    {0, "seed-loop", CMD_CHOICE, 0, 0, "HOW", "+rptam: coverage (default), or brute: every seed everywhere",
     &rptam_options.loop, loops, NULL},
    {0},
};
