/* The techniques of --show. They draw patches or directions instead of strokes. */
#ifndef RENDER_MODE_SHOW_H
#define RENDER_MODE_SHOW_H

#include "render-gl/technique/technique.h"

/* In the order of the option's choices, ended by NULL. */
extern const struct technique *const show_techniques[];

#endif
