/* Evaluates models of recursive procedural tonal art maps at single positions, as the shaders do. */
#ifndef HATCH_TEST_RPTAM_INK_H
#define HATCH_TEST_RPTAM_INK_H

#include <math.h>

#include "seed/rptam.h"

/* Returns the ink of one layer at uv, 0 .. 1: 1 - transmittance. Arguments as for hatch_rptam_pattern_make. */
static inline double rptam_layer_ink(const struct hatch_rptam *rptam, uint32_t layer, const double uv[2], double depth,
                                     double amount, bool all)
{
    struct hatch_rptam_pattern pattern;
    hatch_rptam_pattern_make(rptam, layer, depth, amount, all, &pattern);
    return 1 - hatch_rptam_transmittance(&pattern, uv);
}

/* Returns the ink of all layers at uv, 0 .. 1; their transmittances multiply.
 *   amounts  layer_count entries */
static inline double rptam_ink(const struct hatch_rptam *rptam, const double uv[2], double depth, const double *amounts,
                               bool all)
{
    double transmittance = 1;
    for (uint32_t i = 0; i < rptam->layer_count; i++)
        transmittance *= 1 - rptam_layer_ink(rptam, i, uv, depth, amounts[i], all);
    return 1 - transmittance;
}

/* Computes the amount of each layer for a tone.
 *   darkness  target mean darkness, clamped to 0 .. rptam->darkest
 *   amounts   out: layer_count entries, 0 .. 1 */
static inline void rptam_amounts(const struct hatch_rptam *rptam, double darkness, double *amounts)
{
    double at = rptam->darkest > 0 ? darkness / rptam->darkest * HATCH_RPTAM_TONE_STEPS : 0;
    at = fmin(fmax(at, 0), HATCH_RPTAM_TONE_STEPS);
    uint32_t step = (uint32_t)fmin(at, HATCH_RPTAM_TONE_STEPS - 1);
    double progress = rptam->progress[step] + (at - step) * (rptam->progress[step + 1] - rptam->progress[step]);
    for (uint32_t i = 0; i < rptam->layer_count; i++) {
        const struct hatch_rptam_layer_style *style = &rptam->layers[i].style;
        amounts[i] = fmin(fmax((progress - style->low) / (style->high - style->low), 0), 1);
    }
}

#endif
