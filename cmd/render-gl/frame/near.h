/* Pieces of near faces on the GPU (libhatch's near/near.h makes them). */
#ifndef RENDER_FRAME_NEAR_H
#define RENDER_FRAME_NEAR_H

#include <epoxy/gl.h>

#include "near/near.h"
#include "render-gl/scene/scene.h"

/* Zeroed to begin with. */
struct near {
    struct hatch_near found;
    GLuint array, buffer, views[3]; /* views: vertices, tangents by texture coordinates, repeats, as textures */
    float clip_from_camera[16];
};

/* Finds the near faces of a frame and uploads their pieces; moves the view's near plane where that is automatic. */
enum hatch_status near_begin(struct near *near, const struct scene *scene, const struct hatch_near_options *options,
                             struct hatch_view *view, struct hatch_err *err) HATCH_MUST_USE;

/* Binds what the pieces of an item are drawn with; their program is in use. */
void near_use(const struct near *near, const struct scene *scene, uint32_t item);

/* Leaves *near zeroed. */
void near_free(struct near *near);

#endif
