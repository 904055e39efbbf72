/* How often the hatching pattern repeats over a mesh's texture coordinates. */
#ifndef HATCH_VIEW_UV_REPEAT_H
#define HATCH_VIEW_UV_REPEAT_H

#include "scene/unit_scene.h"
#include "view/view.h"

struct hatch_uv_repeat {
    double repeat;                 /* tiles per unit of u and of v; 0: chosen */
    const struct hatch_view *view; /* the picture that repeats are chosen for */
    double height_px;              /* its height */
    uint32_t size_px;              /* side of a tile at its finest level, in texels */
    uint32_t levels;               /* levels that hold strokes */
};

/* Sets the repeats of every item of a posed scene. Chosen ones are powers of two, of their own for each chart of an
 * item and each direction, so that in the picture texels of the finest level are no larger than pixels, and the
 * coarsest level that holds strokes is not passed. A chart is a connected part of the texture's plane; artists give
 * charts different scales. Lapped meshes have one repeat for all of the scene, at which a texel is a pixel; it need
 * be no power of two, since patches have no seams to close.
 *   arena  keeps the items' repeats */
enum hatch_status hatch_uv_repeat_set(struct hatch_unit_scene *scene, const struct hatch_uv_repeat *how,
                                      struct hatch_arena *arena, struct hatch_arena *scratch,
                                      struct hatch_err *err) HATCH_MUST_USE;

#endif
