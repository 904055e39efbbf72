/* A picture of a solid texture. */
#ifndef SOLIDGEN_SLICES_H
#define SOLIDGEN_SLICES_H

#include "shared/cmd.h"
#include "solid/solid.h"

/* Draws the middle slices across z, y and x beside each other, with a strip of paper between them, as an sRGB PNG. In
 * each, the first of its two axes in the order x, y, z runs to the right and the other one down. Dies on failure.
 *   file  empty; receives the PNG */
void solidgen_draw_slices(struct cmd_args *args, const struct hatch_solid *solid, const char *path,
                          struct hatch_buffer *file);

#endif
