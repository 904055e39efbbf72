/* Vertex attributes that some techniques read beside struct scene_vertex. */
#ifndef RENDER_SCENE_ATTRIBUTES_H
#define RENDER_SCENE_ATTRIBUTES_H

#include "render-gl/scene/scene.h"
#include "view/uv_repeat.h"

/* Sets the repeats of every item of a posed scene, and uploads them. arena: keeps them. */
enum hatch_status scene_set_repeats(struct scene *scene, const struct hatch_uv_repeat *how, struct hatch_arena *arena,
                                    struct hatch_arena *scratch, struct hatch_err *err) HATCH_MUST_USE;

/* Gives every item's vertices their tangents by texture coordinates, and sets uv_reach. Shaped items have none, since
 * their surface moves: shaders take the derivatives of the picture there. Calling it again is cheap. */
enum hatch_status scene_set_uv_tangents(struct scene *scene, struct hatch_arena *scratch,
                                        struct hatch_err *err) HATCH_MUST_USE;

/* Gives the vertices of patches a random tone each, one for a patch, by which patches can be told apart. Calling it
 * again is cheap. */
enum hatch_status scene_set_patch_tones(struct scene *scene, struct hatch_arena *scratch,
                                        struct hatch_err *err) HATCH_MUST_USE;

#endif
