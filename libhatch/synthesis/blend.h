/* The step from matches to texels. */
#ifndef HATCH_SYNTHESIS_BLEND_H
#define HATCH_SYNTHESIS_BLEND_H

#include "synthesis/volume.h"

/* Working space: tables of one step. */
struct hatch_blend_tables {
    float weights[442];      /* by the distance between a texel and the pixel that contributes to it, rounded down */
    uint8_t values[3 * 256]; /* [channel * 256 + mean]: the value that takes the place of a mean */
};

/* Computes the texels of the next iteration and puts them in place. The neighbourhoods over a texel, side² in each of
 * three slices, each contribute a pixel. The means of these with weights distance^(r - 2), r = 0.8, minimise the energy
 * of the paper. The means are mapped so that each channel has the histogram of the exemplar, in place of the paper's
 * change of weights. The texel takes the contributed pixel nearest to its mapped mean, so that the solid has colours of
 * the exemplar only.
 *   tolerance  8-bit distance up to which weights are equal: at 442, means are plain */
void hatch_blend_run(struct hatch_volume *volume, const struct hatch_exemplar *exemplar, uint32_t tolerance,
                     struct hatch_pool *pool, struct hatch_blend_tables *tables);

#endif
