/* How strokes look in a picture: which share of them is grey, and how far their tone and their edges are from
 * those of another picture. hatchstat(1) writes the formulas. */
#ifndef HATCH_MEASURE_INK_FIGURES_H
#define HATCH_MEASURE_INK_FIGURES_H

#include "image/image.h"

#define HATCH_INK_WINDOW_PX 32u

struct hatch_ink_figures {
    double inked;        /* share of the pixels that are not paper */
    double grey;         /* of these, the share that is neither nearly paper nor nearly ink */
    double grey_strokes; /* of these, the share that is grey with no ink beside it: no edge of a stroke */
    /* Against the reference; not numbers where there is none. */
    double tone_error; /* over the windows that the reference darkens: mean of |difference of the mean| */
    double tone_worst; /* and the largest */
    double edge_error; /* over the pixels that are edges in the reference: root of the mean square */
};

/* Pictures in linear light, from 0, ink, to 1, paper, grey or with colours first. reference: NULL, or of the
 * same size. */
enum hatch_status hatch_measure_ink(const struct hatch_image *picture, const struct hatch_image *reference,
                                    struct hatch_arena *scratch, struct hatch_ink_figures *figures,
                                    struct hatch_err *err) HATCH_MUST_USE;

#endif
