/* Techniques of --show, which draw patches or directions instead of strokes. */
#ifndef RENDER_MODE_SHOW_H
#define RENDER_MODE_SHOW_H

#include "render-gl/technique/technique.h"

/* In the order of its choices, ended by NULL. */
extern const struct technique *const show_techniques[];

#endif
