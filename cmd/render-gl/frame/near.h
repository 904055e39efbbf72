/* Pieces of near faces on the GPU. Faces so near the eye that floats cannot place their vertices precisely enough are
 * cut into pieces on the processor (near/near.h). */
#ifndef RENDER_FRAME_NEAR_H
#define RENDER_FRAME_NEAR_H

#include <epoxy/gl.h>

#include "near/near.h"
#include "render-gl/scene/scene.h"

/* Buffer textures: an item's vertices, uv_tangents and repeats, as single floats, and the charts of its mesh. */
enum { NEAR_VIEW_CHARTS = 3, NEAR_VIEWS };

/* Zeroed before the first call. */
struct near {
    struct hatch_near found;
    GLuint array, buffer; /* vertex array and buffer of the pieces; 0: not made */
    GLuint views[NEAR_VIEWS];
    float clip_from_camera[16]; /* column-major */
};

/* Cuts the near faces of a frame into pieces and uploads them.
 *   view  in, out: an automatic near plane is moved to just in front of the nearest surface */
enum hatch_status near_begin(struct near *near, const struct scene *scene, const struct hatch_near_options *options,
                             struct hatch_view *view, struct hatch_err *err) HATCH_MUST_USE;

/* Binds the buffers for the pieces of an item, and sets the uniforms of the program in use.
 *   item  index in scene->items */
void near_use(const struct near *near, const struct scene *scene, uint32_t item);

/* Releases everything; leaves *near zeroed. */
void near_free(struct near *near);

#endif
