/* Textures as output of a command. A command that uses this links the packages texture and exr. */
#ifndef SHARED_TEXELS_H
#define SHARED_TEXELS_H

#include "shared/cmd.h"
#include "image/texels.h"

/* A texture and the metadata of its file. */
struct cmd_texture {
    const struct hatch_texels *texels;
    const char *const *key_values;  /* keys and values alternate, NULL-terminated */
    const char *const *layer_names; /* names of the parts of an EXR; NULL: slice.000, slice.001 and so on */
};

/* Returns whether path ends in ".exr". */
bool cmd_is_exr_path(const char *path);

/* Encodes a texture as KTX2, or as OpenEXR if path ends in .exr. An EXR has one part per layer, or per slice of the
 * finest level of a 3D texture; level l of the part for slice k is slice k >> l of that level. The chain of a part ends
 * with its first level of 1x1 texels. Pixels are half floats, 0 .. 1; the keys become attributes. Dies on failure.
 *   texture  for EXR: of code HATCH_TEXELS_PLAIN
 *   file     empty; receives the result */
void cmd_encode_texture(struct cmd_args *args, const struct cmd_texture *texture, const char *path,
                        struct hatch_buffer *file);

#endif
