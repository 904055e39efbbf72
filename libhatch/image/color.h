/* Colours: parsing, luminance, and the mean chroma and hue of images. */
#ifndef HATCH_IMAGE_COLOR_H
#define HATCH_IMAGE_COLOR_H

#include "base/text.h"
#include "image/image.h"

/* Least chroma at which an image has a meaningful hue. */
#define HATCH_COLOR_CHROMA_MIN 0.02

/* Parses three or six hexadecimal digits, without "#". Returns false for any other text.
 *   digits  sRGB
 *   rgb     out: linear, 0 .. 1; unchanged on failure */
bool hatch_color_from_hex(struct hatch_text digits, float rgb[3]);

/* Parses three, four, six or eight hexadecimal digits, without "#": a colour, and its alpha if there is a fourth
 * number.
 *   rgba  out: linear, 0 .. 1; then alpha, 1 if it is absent; unchanged on failure */
bool hatch_color_from_hex_alpha(struct hatch_text digits, float rgba[4]);

/* Names of colours, NULL at the end. */
extern const char *const hatch_color_names[];

/* Parses a colour: a name, #rgb or #rrggbb. Arguments as for hatch_color_from_hex. */
bool hatch_color_parse(struct hatch_text text, float rgb[3]);

/* Returns the luminance of a linear colour (ITU-R BT.709). */
static inline float hatch_color_luminance(const float rgb[3])
{
    return 0.2126f * rgb[0] + 0.7152f * rgb[1] + 0.0722f * rgb[2];
}

/* Computes the chroma vector of an image's mean colour, (R - (G + B) / 2, (G - B) sqrt(3) / 2): its length is the
 * chroma, its angle the hue.
 *   image  its first three channels are R, G and B */
void hatch_color_chroma(const struct hatch_image *image, double chroma[2]);

/* Returns the angle between two chroma vectors, 0 .. 180 degrees. */
double hatch_color_hue_between(const double a[2], const double b[2]);

#endif
