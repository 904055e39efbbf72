/* The look of strokes in the block of the style. */
#include <string.h>

#include "render-gl/technique/traced/traced.h"

#define MEAN_LEAST 0.25 /* least mean of a profile of width by which widths are divided */

void traced_set_look(const struct hatch_stroke_look *look, double width_px, bool even, struct traced_block *block)
{
    const double mean = fmax(hatch_profile_mean(&look->width), MEAN_LEAST);
    block->zigzag[0] = (float)((double)look->zigzag * width_px);
    block->zigzag[1] = (float)((double)look->zigzag_length * width_px);
    block->zigzag[3] = even ? 1 : (float)hatch_zigzag_stretch(look);
    block->look[0] = even ? 0 : look->width.count;
    block->look[1] = even ? 0 : look->pressure.count;
    block->look[2] = look->color_count;
    block->look[3] = look->mixes;
    for (uint32_t i = 0; i < HATCH_PROFILE_MAX; i++) {
        block->profiles[0][i] = (float)((double)look->width.values[i] / mean);
        block->profiles[1][i] = look->pressure.values[i];
    }
    for (uint32_t i = 0; i < look->color_count; i++)
        memcpy(block->colors[i], look->colors[i], sizeof look->colors[i]);
}
