/* Normal maps: what a material's texture makes of the normals, where light is taken at pixels. Frames are those of
 * glTF 2.0: tangents of the file, or along rising u, and w that says which way v goes. */
#ifndef RENDER_NORMALS_H
#define RENDER_NORMALS_H

#include "shared/cmd.h"
#include "render-gl/scene.h"

/* What the vertex stage reads beside struct vertex. */
struct tangent {
    float along[4]; /* unit, in the mesh; of a skinned item: in the unit scene; w: 1 or -1 */
    float texcoord[2];
};

/* Uploads the textures and frames of the items whose materials have normals. Dies on an image that cannot be read.
 * file: the scene's name for messages. The scene is posed afterwards. */
void normals_upload(struct cmd_args *args, const char *file, uint32_t size_max_px, struct gpu_scene *gpu);

/* The same for one item that has the texture coordinates, and with a texture that is uploaded:
 * from now on it is the item's. The arena keeps the frames. */
enum hatch_status normals_set(const struct gpu_scene *gpu, struct gpu_item *item,
                              const struct hatch_normal_map *normals, GLuint texture, struct hatch_arena *arena,
                              struct hatch_arena *scratch, struct hatch_err *err) HATCH_MUST_USE;

/* Poses the tangents of a skinned item, whose posed positions are given: three numbers of the world a vertex. */
enum hatch_status normals_pose(const struct gpu_scene *gpu, const struct gpu_item *item, const double *positions,
                               struct hatch_arena *scratch, struct hatch_err *err) HATCH_MUST_USE;

void normals_free(struct gpu_item *item);

#endif
