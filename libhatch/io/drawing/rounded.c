#include "io/drawing/rounded.h"

#include <math.h>

#include "image/image.h"
#include "image/texels.h"

double hatch_drawing_round(double mm)
{
    return (double)llround(mm * HATCH_DRAWING_UNITS) / HATCH_DRAWING_UNITS;
}

double hatch_drawing_pen(const struct hatch_drawing_layer *layer)
{
    return hatch_drawing_round(fmax(layer->pen_mm, 1 / HATCH_DRAWING_UNITS));
}

void hatch_drawing_codes(const float linear[3], uint8_t codes[3])
{
    for (int k = 0; k < 3; k++)
        codes[k] = hatch_unorm8(hatch_linear_to_srgb(linear[k]));
}
