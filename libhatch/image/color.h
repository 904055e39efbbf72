/* Colours as people write them. */
#ifndef HATCH_IMAGE_COLOR_H
#define HATCH_IMAGE_COLOR_H

#include "base/text.h"

/* Three or six hexadecimal digits, sRGB, without the "#" before them, as linear 0..1. False, and rgb as it
 * was, for anything else. */
bool hatch_color_from_hex(struct hatch_text digits, float rgb[3]);

#endif
