/* Vertex attributes that some techniques need in addition to struct scene_vertex. */
#ifndef RENDER_SCENE_ATTRIBUTES_H
#define RENDER_SCENE_ATTRIBUTES_H

#include "render-gl/scene/scene.h"
#include "view/uv_repeat.h"

/* Computes how often the map repeats per unit of u and v on each item of a posed scene (hatch_uv_repeat_set), and
 * uploads the result.
 *   arena  holds the repeats of vertices; must live as long as the scene */
enum hatch_status scene_set_repeats(struct scene *scene, const struct hatch_uv_repeat *how, struct hatch_arena *arena,
                                    struct hatch_arena *scratch, struct hatch_err *err) HATCH_MUST_USE;

/* As scene_set_repeats, for another texture than the map, until scene_restore_repeats. Called again with the same
 * texture, it computes nothing. */
enum hatch_status scene_replace_repeats(struct scene *scene, const struct hatch_uv_repeat *how,
                                        struct hatch_arena *arena, struct hatch_arena *scratch,
                                        struct hatch_err *err) HATCH_MUST_USE;
void scene_restore_repeats(struct scene *scene);

/* Computes the derivatives of the surface along u and v at every vertex, uploads them, and sets uv_reach of every item.
 * Items with skins or morph targets get no derivatives, because their surface moves; shaders use screen-space
 * derivatives for them. Meshes without TEXCOORD_0 are skipped. Repeated calls upload nothing. */
enum hatch_status scene_set_uv_tangents(struct scene *scene, struct hatch_arena *scratch,
                                        struct hatch_err *err) HATCH_MUST_USE;

/* Makes the positions of undeformed vertices an attribute of every item. Repeated calls change nothing. */
void scene_set_rest(struct scene *scene);

/* Gives every patch of lapped meshes a random tone, as a vertex attribute, so that patches can be told apart. Repeated
 * calls make no new tones. */
enum hatch_status scene_set_patch_tones(struct scene *scene, struct hatch_arena *scratch,
                                        struct hatch_err *err) HATCH_MUST_USE;

/* Uploads the number of each vertex's chart (scene/uv_charts.h) or, of lapped meshes, of its patch. Meshes without
 * TEXCOORD_0 are skipped. Repeated calls upload nothing. */
enum hatch_status scene_set_charts(struct scene *scene, struct hatch_arena *scratch,
                                   struct hatch_err *err) HATCH_MUST_USE;

#endif
