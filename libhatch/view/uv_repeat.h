/* Chooses the number of tiles of the hatching pattern per unit of a mesh's texture coordinates. */
#ifndef HATCH_VIEW_UV_REPEAT_H
#define HATCH_VIEW_UV_REPEAT_H

#include "scene/unit_scene.h"
#include "view/view.h"

/* Options of hatch_uv_repeat_set. */
struct hatch_uv_repeat {
    double repeat;                 /* tiles per unit of u and of v; 0: they are chosen for the view */
    const struct hatch_view *view; /* view of the picture for which repeats are chosen */
    double height_px;              /* height of that picture */
    uint32_t size_px;              /* side of the tile at level 0, in texels */
    uint32_t levels;               /* number of levels with strokes */
};

/* Sets the repeats of every item of a posed scene. Repeats that are chosen for the view are powers of two, separately
 * for each chart of an item and each direction. With them, texels of level 0 are about as large as pixels, and no level
 * without strokes is drawn. (A chart is a connected part of the surface in texture space; charts of one mesh often have
 * different scales.) Lapped textures have one scale for the whole scene, at which a texel of level 0 is a pixel; as
 * patches have no seams, it need not be a power of two.
 *   arena  for the items' repeats */
enum hatch_status hatch_uv_repeat_set(struct hatch_unit_scene *scene, const struct hatch_uv_repeat *how,
                                      struct hatch_arena *arena, struct hatch_arena *scratch,
                                      struct hatch_err *err) HATCH_MUST_USE;

#endif
