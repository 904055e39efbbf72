/* The exemplar at one level of detail, in 8 bits per channel. */
#ifndef HATCH_SYNTHESIS_EXEMPLAR_H
#define HATCH_SYNTHESIS_EXEMPLAR_H

#include "image/image.h"
#include "synthesis/synthesis.h"

#define HATCH_EXEMPLAR_PITCH HATCH_SYNTHESIS_EXEMPLAR_MAX /* pixels from one row to the next */

#define HATCH_EXEMPLAR_VALUES_MAX (HATCH_SYNTHESIS_SIDE_MAX * HATCH_SYNTHESIS_SIDE_MAX * 3u) /* of a neighbourhood */

/* A neighbourhood of the exemplar is named by its top left pixel: y * HATCH_EXEMPLAR_PITCH + x, in 16 bits. */
struct hatch_exemplar {
    uint32_t width, height, channels;
    uint32_t side;         /* of neighbourhoods */
    uint32_t across, down; /* numbers of neighbourhoods that lie inside: width - side + 1, height - side + 1 */
    uint8_t *pixels;       /* [(y * HATCH_EXEMPLAR_PITCH + x) * channels + c] */
};

/* Makes the level of an image of up to HATCH_SYNTHESIS_EXEMPLAR_MAX pixels in each direction.
 *   side  of neighbourhoods; at most that of the image */
enum hatch_status hatch_exemplar_make(const struct hatch_image *image, uint32_t side, struct hatch_arena *arena,
                                      struct hatch_exemplar *exemplar, struct hatch_err *err) HATCH_MUST_USE;

/* Returns the squared distance between values and a neighbourhood of the exemplar; from `enough` on, any number that is
 * not smaller.
 *   values  [side * side * channels], row by row: 8-bit values - 128 */
uint32_t hatch_exemplar_distance(const struct hatch_exemplar *exemplar, const int16_t *values, uint32_t match,
                                 uint32_t enough);

#endif
