/* Draws seed sets as in Figure 3 of the paper. */
#ifndef SEEDGEN_PLOT_H
#define SEEDGEN_PLOT_H

#include "shared/cmd.h"
#include "seed/seeds.h"

/* Returns an SVG, in args->keep: one panel per layer with its seed points as large circles and, as small circles, the
 * same pattern at half its size repeated 2 by 2. Every seed point coincides with one of these. */
struct hatch_bytes plot_seeds(struct cmd_args *args, const struct hatch_seeds *seeds);

#endif
