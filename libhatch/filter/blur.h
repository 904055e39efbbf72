/* Box blur of periodic images. */
#ifndef HATCH_FILTER_BLUR_H
#define HATCH_FILTER_BLUR_H

#include "image/image.h"

/* Computes for every pixel the mean of a channel over a square box, which wraps around at the borders. Sums are in
 * doubles, in a fixed order.
 *   side     of the box in pixels, 1 .. min(width, height)
 *   blurred  out: width * height; [y * width + x] is for the box with its top left pixel at (x, y) */
enum hatch_status hatch_blur_box(const struct hatch_image *image, uint32_t channel, uint32_t side,
                                 struct hatch_arena *scratch, double *blurred, struct hatch_err *err) HATCH_MUST_USE;

#endif
