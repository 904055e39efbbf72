/* Makes mip levels with a box filter. */
#ifndef HATCH_FILTER_PYRAMID_H
#define HATCH_FILTER_PYRAMID_H

#include "image/image.h"

/* Sets each pixel of coarse to the mean of the fine pixels under it. At odd sizes the fine pixels are weighted by the
 * area that is covered, so that the mean of the image is kept.
 *   coarse  of size max(1, fine / 2) in each direction, with the same channels */
void hatch_image_halve(const struct hatch_image *fine, struct hatch_image *coarse);

/* Completes a mip chain down to 1×1 by halving, and sets level_count.
 *   mipmap  levels 0 .. first-1 are given; levels has room for HATCH_MIP_LEVELS_MAX
 *   first   first level to make, at least 1
 *   arena   for the pixels */
enum hatch_status hatch_mipmap_complete(struct hatch_mipmap *mipmap, uint32_t first, struct hatch_arena *arena,
                                        struct hatch_err *err) HATCH_MUST_USE;

#endif
