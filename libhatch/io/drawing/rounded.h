/* Numbers and colours of drawings as files hold them, so that those of a drawing are the same in each format. */
#ifndef HATCH_IO_DRAWING_ROUNDED_H
#define HATCH_IO_DRAWING_ROUNDED_H

#include "vector/drawing.h"

#define HATCH_DRAWING_UNITS 1000.0 /* of a millimetre: lengths are multiples of one */

/* Returns a length on the page, rounded. */
double hatch_drawing_round(double mm);

/* Returns the width of a layer's pen, rounded, but over 0. */
double hatch_drawing_pen(const struct hatch_drawing_layer *layer);

/* Rounds a colour.
 *   linear  linear light
 *   codes   out: sRGB */
void hatch_drawing_codes(const float linear[3], uint8_t codes[3]);

#endif
