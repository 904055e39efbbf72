/* How far images are from each other. hatchstat(1) writes the same formulas for its users. */
#ifndef HATCH_FILTER_DIFFERENCE_H
#define HATCH_FILTER_DIFFERENCE_H

#include "image/image.h"

/* Over all pixels and channels, d = a - b. */
struct hatch_difference {
    double max, mean; /* of |d| */
    double bias;      /* mean of d */
    double rmse;      /* root of the mean of d^2 */
    double psnr_db;   /* -20 log10(rmse): of numbers from 0 to 1; infinite when nothing differs */
    double differing; /* share of the pixels of which any channel differs, 0 .. 1 */
};

/* a and b: same size and number of channels. */
void hatch_image_difference(const struct hatch_image *a, const struct hatch_image *b,
                            struct hatch_difference *difference);

/* The largest |mean of a - b| over all box_px x box_px windows that lie within the image, of any
 * channel: what is left of a difference when fine structure is averaged away. A window is no larger
 * than the image. b may be NULL: the largest |mean of a|. box_px: at least 1. */
enum hatch_status hatch_image_low_difference(const struct hatch_image *a, const struct hatch_image *b, uint32_t box_px,
                                             struct hatch_arena *scratch, double *difference,
                                             struct hatch_err *err) HATCH_MUST_USE;

/* The mean of all numbers of an image. */
double hatch_image_mean(const struct hatch_image *image);

/* change = before - 2 now + after, pixel by pixel: zero where light changes evenly over three
 * frames, large where something pops. All of the same size; change may be one of them. Returns the
 * mean of |change|. */
double hatch_image_second_difference(const struct hatch_image *before, const struct hatch_image *now,
                                     const struct hatch_image *after, struct hatch_image *change);

#endif
