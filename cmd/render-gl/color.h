/* Colours as people write them. */
#ifndef RENDER_COLOR_H
#define RENDER_COLOR_H

#include "base/text.h"

/* black, white, grey, cream, sepia, blue, red, or #rgb and #rrggbb (sRGB), as linear light. false: none. */
bool color_parse(struct hatch_text text, float rgb[3]);

/* Three finite numbers with commas between: "0,1.5,2". */
bool vector_parse(struct hatch_text text, double xyz[3]);

#endif
