/* The materials' colours and textures, where they matter: as tone, and as holes. */
#ifndef RENDER_SCENE_MATERIAL_H
#define RENDER_SCENE_MATERIAL_H

#include "shared/cmd.h"
#include "image/image.h"
#include "render-gl/scene/scene.h"

/* Decodes and uploads the base-colour textures that items need, each once, and sets the items'
 * fields. as_tone: colours count as tone; otherwise only holes do. Dies on an image that cannot be
 * read; one that is wider or higher than size_max_px is halved until it is not. file: the scene's name for
 * messages. */
void material_upload(struct cmd_args *args, const char *file, bool as_tone, uint32_t size_max_px, struct scene *scene);

/* Gives every item without patches and holes an image as its tone, by its texture coordinates, in place of
 * what its material says (Webb et al. 2002, §3.2: the globe). Dies on an image that cannot be read. */
void material_modulate(struct cmd_args *args, const char *path, uint32_t size_max_px, struct scene *scene);

/* Decodes and uploads a texture of normals, as numbers. Dies on an image that cannot be read or is grey. */
GLuint material_normals(struct cmd_args *args, const char *file, const struct hatch_scene *scene,
                        const struct hatch_normal_map *normals, uint32_t size_max_px);

/* Uploads the alpha of an image as the outline of patches; without alpha it is 1. Outside of the image it
 * is 0. No level coarser than the third is read: those would thin the outline's opaque middle, and what
 * lies below would show between patches. */
enum hatch_status material_outline(const struct hatch_image *image, struct hatch_arena *scratch, GLuint *texture,
                                   struct hatch_err *err) HATCH_MUST_USE;

#endif
