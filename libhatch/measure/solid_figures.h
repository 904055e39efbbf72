/* Measurements of solid textures; hatchstat(1) has the formulas. */
#ifndef HATCH_MEASURE_SOLID_FIGURES_H
#define HATCH_MEASURE_SOLID_FIGURES_H

#include "base/parallel.h"
#include "image/image.h"
#include "solid/solid.h"

#define HATCH_SOLID_NEIGHBORHOOD 8u /* side of the neighbourhoods that are compared, in texels */

struct hatch_solid_figures {
    double mean[3], deviation[3]; /* of each channel; NaN where there is none */
    double step[3];               /* mean |difference| of neighbours along x, y and z */
    double isotropy;              /* smallest over largest step; 1 where all are 0 */
    double seam;                  /* mean |difference| across the border over the largest between slices inside */
    /* Against an exemplar; NaN without one. */
    double histogram;        /* earth mover's distance between histograms, mean over the channels */
    double neighborhood[3];  /* in slices across x, y and z: mean distance to the nearest neighbourhood */
    double neighborhood_all; /* mean of the three */
};

/* Measures a solid texture.
 *   exemplar  picture from which it was made; may be NULL
 *   samples   number of texels whose neighbourhoods are compared, at least 1 */
enum hatch_status hatch_measure_solid(const struct hatch_solid *solid, const struct hatch_image *exemplar,
                                      uint32_t samples, struct hatch_pool *pool, struct hatch_arena *scratch,
                                      struct hatch_solid_figures *figures, struct hatch_err *err) HATCH_MUST_USE;

#endif
