/* Colours as people write them, and what colour an image has. */
#ifndef HATCH_IMAGE_COLOR_H
#define HATCH_IMAGE_COLOR_H

#include "base/text.h"
#include "image/image.h"

/* Three or six hexadecimal digits, sRGB, without the "#" before them, as linear 0..1. False, and rgb as it
 * was, for anything else. */
bool hatch_color_from_hex(struct hatch_text digits, float rgb[3]);

/* How light a linear colour is, by the weights of ITU-R BT.709. */
static inline float hatch_color_luminance(const float rgb[3])
{
    return 0.2126f * rgb[0] + 0.7152f * rgb[1] + 0.0722f * rgb[2];
}

/* The mean of the first three channels, R, G and B, as a vector whose length is the chroma and whose angle the
 * hue: (R - (G + B) / 2, (G - B) sqrt(3) / 2). image: of at least three channels. */
void hatch_color_chroma(const struct hatch_image *image, double chroma[2]);

/* The angle between two such vectors, degrees, 0 .. 180. */
double hatch_color_hue_between(const double a[2], const double b[2]);

/* Below that chroma a hue says nothing. */
#define HATCH_COLOR_CHROMA_MIN 0.02

/* Parses black, white, grey, cream, sepia, blue, red, or #rgb and #rrggbb (sRGB), as linear light. Returns false for
 * any other text. */
bool hatch_color_parse(struct hatch_text text, float rgb[3]);

#endif
