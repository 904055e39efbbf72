/* Measurements of strokes where patches of a lapped texture meet in a picture; hatchstat(1) has the formulas. */
#ifndef HATCH_MEASURE_BORDER_FIGURES_H
#define HATCH_MEASURE_BORDER_FIGURES_H

#include "image/image.h"

#define HATCH_BORDER_NEAR_PX 2   /* a pixel is near a border if another patch is at most so many pixels away */
#define HATCH_BORDER_REACH_PX 8  /* pixels up to which ink is followed from there */
#define HATCH_BORDER_SHIFT_PX 16 /* pixels by which borders are moved to places that have none */

/* NaN where there is no ink to measure. */
struct hatch_border_figures {
    double across; /* share of the ink near borders that goes on beyond them */
    double inside; /* the same for the borders moved into the patches: the ends of strokes that borders do not cause */
    double continuity; /* across / inside */
};

/* Measures a picture of strokes.
 *   picture  in linear light, 0 (ink) to 1 (paper): grey, or colours in the first three channels
 *   patches  of the same size: each patch in a grey of its own; white or transparent: no patch */
enum hatch_status hatch_measure_borders(const struct hatch_image *picture, const struct hatch_image *patches,
                                        struct hatch_arena *scratch, struct hatch_border_figures *figures,
                                        struct hatch_err *err) HATCH_MUST_USE;

#endif
