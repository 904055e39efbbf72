/* How often the tonal art map repeats over a mesh's texture coordinates. */
#ifndef RENDER_REPEAT_H
#define RENDER_REPEAT_H

#include "render-gl/scene.h"
#include "scene/view.h"

/* Sets the repeats of every item. repeat > 0: that, for u and v. 0: powers of two, of its own for each
 * chart of an item and each direction, so that in a picture height_px high, from where the view is,
 * texels of the finest level are no larger than pixels, and the coarsest level that holds strokes is
 * not passed. A chart is what hangs together in the texture's plane; artists give charts different
 * scales. Patches have one scale for all of the scene's, at which a texel is a pixel, and which need be no
 * power of two: they have no seams to close. size_px, levels: of the map. The scene is posed. */
enum hatch_status repeat_set(struct gpu_scene *scene, double repeat, const struct hatch_view *view, double height_px,
                             uint32_t size_px, uint32_t levels, struct hatch_arena *scratch,
                             struct hatch_err *err) HATCH_MUST_USE;

#endif
