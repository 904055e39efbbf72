/* Box blur on the torus. */
#ifndef HATCH_FILTER_BLUR_H
#define HATCH_FILTER_BLUR_H

#include "image/image.h"

/* blurred[y * width + x] = the mean of one channel over the box of `side` pixels each way whose top
 * left pixel is (x, y), wrapping around. Sums are in doubles, in a fixed order. side: 1 .. width and
 * height. blurred: width * height doubles. */
enum hatch_status hatch_blur_box(const struct hatch_image *image, uint32_t channel, uint32_t side,
                                 struct hatch_arena *scratch, double *blurred, struct hatch_err *err) HATCH_MUST_USE;

#endif
