/* Seed sets as a drawing: the paper's Figure 3. */
#ifndef SEEDGEN_PLOT_H
#define SEEDGEN_PLOT_H

#include "shared/cmd.h"
#include "seed/seeds.h"

/* An SVG in args->keep: a panel for each layer with its seeds as large circles and, small, the same
 * pattern repeated on a 2 by 2 grid: every seed coincides with one of these. */
struct hatch_bytes plot_seeds(struct cmd_args *args, const struct hatch_seeds *seeds);

#endif
