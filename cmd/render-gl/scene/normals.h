/* Normal maps of materials, where light is computed per pixel. Frames are those of glTF 2.0: tangents of the file, or
 * along rising u, and w, the direction of v. */
#ifndef RENDER_SCENE_NORMALS_H
#define RENDER_SCENE_NORMALS_H

#include "render-gl/scene/scene.h"
#include "shared/cmd.h"

/* A vertex's frame, beside struct scene_vertex. */
struct scene_tangent {
    float along[4]; /* unit, in the mesh; of a deformed item: in the unit scene; w: 1 or -1 */
    float texcoord[2];
};

/* Uploads the normal maps and frames of the items whose materials have them. The scene is posed afterwards.
 *   file  the scene's name for messages
 * Dies on an image that cannot be read. */
void normals_upload(struct cmd_args *args, const char *file, uint32_t size_max_px, struct scene *scene);

/* Gives one item a normal map.
 *   texture  from now on the item's
 *   arena    keeps the frames */
enum hatch_status normals_set(struct scene *scene, uint32_t item, const struct hatch_normal_map *normals,
                              GLuint texture, struct hatch_arena *arena, struct hatch_arena *scratch,
                              struct hatch_err *err) HATCH_MUST_USE;

/* Poses the frames of a deformed item. positions: its posed vertices, 3 per vertex, in the world. */
enum hatch_status normals_pose(const struct scene *scene, uint32_t item, const double *positions,
                               struct hatch_arena *scratch, struct hatch_err *err) HATCH_MUST_USE;

#endif
