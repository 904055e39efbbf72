/* Normal maps of materials, for light per pixel. Tangent frames follow glTF 2.0: the tangent of a vertex is TANGENT of
 * the file, or else the direction in which u rises; its w is the handedness. */
#ifndef RENDER_SCENE_NORMALS_H
#define RENDER_SCENE_NORMALS_H

#include "render-gl/scene/scene.h"
#include "shared/cmd.h"

/* Tangent frame of a vertex, in addition to struct scene_vertex. */
struct scene_tangent {
    float along[4];    /* unit tangent in mesh space (a deformed item: in the unit scene); w: handedness, 1 or -1 */
    float texcoord[2]; /* where the normal map is read */
};

/* Uploads the normal maps, each once, and tangent frames of all items whose materials have a normal map. Call before
 * scene_set_pose. Exits with a message on an image that cannot be read.
 *   file         the scene's name, for messages
 *   size_max_px  larger images are halved until they fit */
void normals_upload(struct cmd_args *args, const char *file, uint32_t size_max_px, struct scene *scene);

/* Gives an item a normal map and uploads its tangent frames.
 *   item     index in scene->items
 *   texture  the normal map; the items that are given it own it from now on
 *   arena    holds the tangent frames at rest; must live as long as the scene */
enum hatch_status normals_set(struct scene *scene, uint32_t item, const struct hatch_normal_map *normals,
                              GLuint texture, struct hatch_arena *arena, struct hatch_arena *scratch,
                              struct hatch_err *err) HATCH_MUST_USE;

/* Updates the tangent frames of a deformed item to the scene's current pose.
 *   item       index in scene->items
 *   positions  posed vertices of the item in world space, 3 numbers each */
enum hatch_status normals_pose(const struct scene *scene, uint32_t item, const double *positions,
                               struct hatch_arena *scratch, struct hatch_err *err) HATCH_MUST_USE;

#endif
