/* Techniques of --show: looks at parametrization and directions instead of strokes. */
#ifndef RENDER_MODE_SHOW_H
#define RENDER_MODE_SHOW_H

#include "render-gl/mode/options.h"

/* The choices of --show; the last has no name. */
extern const struct options_shown show_choices[];

#endif
