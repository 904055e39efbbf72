/* Techniques of --show, which draw patches or directions instead of strokes. */
#ifndef RENDER_MODE_SHOW_H
#define RENDER_MODE_SHOW_H

#include "render-gl/mode/options.h"

/* The choices of --show, ended by one whose name is NULL. */
extern const struct options_shown show_choices[];

#endif
