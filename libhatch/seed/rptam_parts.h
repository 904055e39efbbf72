/* What drawing and measuring recursive procedural tonal art maps share. */
#ifndef HATCH_SEED_RPTAM_PARTS_H
#define HATCH_SEED_RPTAM_PARTS_H

#include "seed/rptam.h"

/* What is left of a stroke, 0 .. 1, is the product of these two. tile: which of four the stroke stands in; m:
 * between the levels, 0 .. 1. */
double hatch_rptam_depth_weight(const struct hatch_rptam *rptam, const struct hatch_rptam_layer *layer,
                                uint32_t seed, uint8_t tile, double m);
double hatch_rptam_tone_weight(const struct hatch_rptam *rptam, const struct hatch_rptam_layer *layer,
                               uint32_t seed, double amount);

/* The ink of a stroke of that weight. d: the place less the seed, in tiles, each -1/2 .. 1/2; tile_px: the
 * tile's side, which is the style's at m = 0 and half of it at m = 1. */
double hatch_rptam_stroke_ink(const struct hatch_rptam *rptam, const struct hatch_rptam_layer *layer,
                              const double d[2], double tile_px, double weight);

/* Fills in every layer's darkness. */
enum hatch_status hatch_rptam_measure(struct hatch_rptam *rptam, struct hatch_arena *scratch,
                                      struct hatch_err *err) HATCH_MUST_USE;

#endif
