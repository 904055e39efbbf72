/* The tones of the pixels of a picture, and the range of them that a picture needs. */
#ifndef HATCH_NEEDS_TONES_H
#define HATCH_NEEDS_TONES_H

#include <stdint.h>

#define HATCH_NEEDS_BINS 4096u

/* Tones of pixels in bins of equal width. Sums are of whole numbers, so that their order does not matter. Zeroed: no
 * pixel. */
struct hatch_needs_tones {
    uint64_t count[HATCH_NEEDS_BINS]; /* pixels */
    uint64_t sum[HATCH_NEEDS_BINS];   /* of their tones, in steps of 2^-24 */
};

/* Adds a pixel.
 *   tone  0 .. 1 */
void hatch_needs_add(struct hatch_needs_tones *tones, double tone);

/* Returns the mean difference that remains if no tone over `limit` is drawn: pixels that want more are drawn as limit.
 *   pixels  over which the mean is taken; 0: the result is 0 */
double hatch_needs_excess(const struct hatch_needs_tones *tones, uint64_t pixels, double limit);

/* Returns the least tone d such that the excess over d is at most the tolerance. It is 0 or over that of
 * hatch_needs_excess by at most a bin.
 *   tolerance  over 0 */
double hatch_needs_darkest(const struct hatch_needs_tones *tones, uint64_t pixels, double tolerance);

/* Returns the greatest tone d such that the mean difference is at most the tolerance if pixels lighter than d are drawn
 * as d; at most the greatest tone of a pixel. */
double hatch_needs_lightest(const struct hatch_needs_tones *tones, uint64_t pixels, double tolerance);

#endif
