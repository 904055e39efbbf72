/* Measurements of the strokes in a picture: the share that is grey, and the errors of tone and edges against a
 * reference; hatchstat(1) has the formulas. */
#ifndef HATCH_MEASURE_INK_FIGURES_H
#define HATCH_MEASURE_INK_FIGURES_H

#include "image/image.h"

#define HATCH_INK_WINDOW_PX 32u /* side of the windows of tones */
#define HATCH_INK_EVEN_PX 24u   /* side of the windows of unevenness */

struct hatch_ink_figures {
    double inked; /* share of the pixels that are not paper */
    /* Shares of the inked pixels; NaN if there are none. */
    double grey;         /* those that are grey */
    double grey_strokes; /* those that are grey and, unlike edges, have no ink next to them */
    double black;        /* those that are nearly all ink */
    double width_px; /* mean width of strokes: twice the ink over the length of its outline; NaN without an outline */
    /* Errors against the reference; NaN without one, or if it has no such windows or pixels. */
    double tone_error; /* mean of |difference of mean darkness| over the windows that the reference darkens */
    double tone_worst; /* largest of these differences */
    double edge_error; /* root mean square difference of darkness over the reference's edge pixels */
    double tone_rms;   /* root mean square of the differences of tone_error */
    double uneven24;   /* standard deviation of such differences, over windows of HATCH_INK_EVEN_PX */
};

/* Returns the darkness of each pixel, 0 (paper) .. 1 (ink).
 *   image  in linear light: grey, or colours in the first three channels
 * NULL when memory does not suffice. */
float *hatch_ink_darkness(const struct hatch_image *image, struct hatch_arena *arena,
                          struct hatch_err *err) HATCH_MUST_USE;

/* Measures a picture in linear light, 0 (ink) to 1 (paper): grey, or colours in the first three channels.
 *   reference  of the same size; may be NULL */
enum hatch_status hatch_measure_ink(const struct hatch_image *picture, const struct hatch_image *reference,
                                    struct hatch_arena *scratch, struct hatch_ink_figures *figures,
                                    struct hatch_err *err) HATCH_MUST_USE;

#endif
