/* Base colours and base-colour textures of materials. They are used in four ways: as tone, as colour, as holes (where
 * alpha is below the material's cutoff), and as the outline of lapped patches. */
#ifndef RENDER_SCENE_MATERIAL_H
#define RENDER_SCENE_MATERIAL_H

#include "shared/cmd.h"
#include "image/image.h"
#include "render-gl/scene/scene.h"

/* Decodes and uploads the base-colour textures that items need, each once, and sets the base_... members of the items.
 * Exits with a message on an image that cannot be read.
 *   file         the scene's name, for messages
 *   visible      true: textures are also uploaded for use as tone or as colour; false: only for holes and outlines
 *   size_max_px  larger images are halved until they fit */
void material_upload(struct cmd_args *args, const char *file, bool visible, uint32_t size_max_px, struct scene *scene);

/* Sets cut_out of the items whose texture has holes; decodes each texture once. Needs no context. Exits with a message
 * on an image that cannot be read. */
void material_find_holes(struct cmd_args *args, const char *file, struct hatch_unit_scene *unit);

/* Replaces the base texture of every item that has neither patches nor holes by one image, which they share, to be used
 * as tone (as for the globe in Webb et al. 2002, §3.2). Textures that no item uses any more are deleted. Exits with a
 * message on an image that cannot be read.
 *   path         path of the image
 *   size_max_px  larger images are halved until they fit */
void material_modulate(struct cmd_args *args, const char *path, uint32_t size_max_px, struct scene *scene);

/* Decodes and uploads a normal map without colour conversion. Exits with a message on an image that cannot be read or
 * has fewer than 3 channels.
 *   file         the scene's name, for messages
 *   size_max_px  larger images are halved until they fit
 * Returns a texture, which the caller owns. */
GLuint material_normals(struct cmd_args *args, const char *file, const struct hatch_scene *scene,
                        const struct hatch_normal_map *normals, uint32_t size_max_px);

/* Uploads the alpha of an image, as the outline of patches, to the red channel of a texture. It is 1 everywhere in an
 * image without alpha, and 0 outside the image. It has the levels that hatch_outline_levels tells: in coarser
 * ones the opaque middle of the outline would shrink, and the paper below would show between patches.
 *   texture  out: owned by the caller */
enum hatch_status material_outline(const struct hatch_image *image, struct hatch_arena *scratch, GLuint *texture,
                                   struct hatch_err *err) HATCH_MUST_USE;

#endif
