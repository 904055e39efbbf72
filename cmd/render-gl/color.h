/* Colours as people write them. */
#ifndef RENDER_COLOR_H
#define RENDER_COLOR_H

#include <stdbool.h>

/* black, white, grey, cream, sepia, blue, or #rgb and #rrggbb (sRGB), as linear light. false: none. */
bool color_parse(const char *text, float rgb[3]);

/* Three finite numbers with commas between: "0,1.5,2". */
bool vector_parse(const char *text, double xyz[3]);

#endif
