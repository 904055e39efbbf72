/* Mip levels by box filter. */
#ifndef HATCH_FILTER_PYRAMID_H
#define HATCH_FILTER_PYRAMID_H

#include "image/image.h"

/* Fills coarse (of size max(1, fine/2) each way) with the mean of the fine pixels that each of its
 * pixels covers; where a size is odd, fine pixels count by the share that is covered, so that the mean
 * of the whole image is kept. Same channels. */
void hatch_image_halve(const struct hatch_image *fine, struct hatch_image *coarse);

/* Makes all levels of mipmap from `first` to the end of a full chain down to 1×1, each the box-filtered
 * one before it, in arena, and sets level_count. Levels 0 .. first-1 hold their images already, and
 * levels has room for HATCH_MIP_LEVELS_MAX. first: at least 1. */
enum hatch_status hatch_mipmap_complete(struct hatch_mipmap *mipmap, uint32_t first, struct hatch_arena *arena,
                                        struct hatch_err *err) HATCH_MUST_USE;

#endif
