/* The technique that --needs measures with: it draws numbers instead of colours. */
#ifndef RENDER_MODE_NEEDS_TECHNIQUE_H
#define RENDER_MODE_NEEDS_TECHNIQUE_H

#include "render-gl/technique/technique.h"

/* A map that no view magnifies, with levels down to 32 pixels, as tamgen makes them. */
#define NEEDS_SIZE_PX (1u << 20)
#define NEEDS_LEVELS 16u

extern const struct technique needs_technique;

/* Returns what the last frame was drawn into: two outputs as shaders/needs/needs.frag writes them, single floats.
 * Pixels that show nothing have 0 in the fourth channel of the first output. Valid until the next frame. */
const struct gpu_target *needs_target(const struct technique_instance *instance);

#endif
