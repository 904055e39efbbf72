/* Compares images; hatchstat(1) documents the formulas. */
#ifndef HATCH_FILTER_DIFFERENCE_H
#define HATCH_FILTER_DIFFERENCE_H

#include "image/image.h"

/* Statistics of d = a - b over all pixels and channels. Where a value is NaN in one image, d is infinite for max and
 * differing, and 0 for the others; where it is NaN in both, d is 0. */
struct hatch_difference {
    double max, mean; /* of |d| */
    double bias;      /* mean of d */
    double rmse;      /* root of the mean of d² */
    double psnr_db;   /* -20 log10(rmse), for values of 0 .. 1; infinite for equal images */
    double differing; /* share of pixels in which a channel differs, 0 .. 1 */
};

/* Compares two images of the same size and number of channels. */
void hatch_image_difference(const struct hatch_image *a, const struct hatch_image *b,
                            struct hatch_difference *difference);

/* Computes the difference of two images at low frequencies: the largest |mean of a - b| over all windows of box_px by
 * box_px pixels and all channels. NaN counts as no difference.
 *   b       of a's size and channels; NULL: an image of zeros
 *   box_px  at least 1; windows are at most as large as the image */
enum hatch_status hatch_image_low_difference(const struct hatch_image *a, const struct hatch_image *b, uint32_t box_px,
                                             struct hatch_arena *scratch, double *difference,
                                             struct hatch_err *err) HATCH_MUST_USE;

/* Returns the mean over all pixels and channels. */
double hatch_image_mean(const struct hatch_image *image);

/* Computes before - 2 now + after per pixel and channel: zero where brightness changes evenly over three frames, large
 * where something pops. Returns the mean of its absolute values.
 *   change  out: of the same size; may be one of the inputs */
double hatch_image_second_difference(const struct hatch_image *before, const struct hatch_image *now,
                                     const struct hatch_image *after, struct hatch_image *change);

#endif
