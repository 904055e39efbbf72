/* The materials' colours and textures, where they matter: as tone, and as holes. */
#ifndef RENDER_MATERIAL_H
#define RENDER_MATERIAL_H

#include "cmd.h"
#include "render-gl/scene.h"

/* Decodes and uploads the base-colour textures that items need, each once, and sets the items'
 * fields. as_tone: colours count as tone; otherwise only holes do. Dies on an image that cannot be
 * read. file: the scene's name for messages. */
void material_upload(struct cmd_args *args, const char *file, bool as_tone, struct gpu_scene *gpu);

void material_free(struct gpu_scene *gpu);

#endif
