/* Writing textures: what every command does that makes one. A command that uses this links the packages
 * container and exr. */
#ifndef HATCH_CMD_TEXELS_H
#define HATCH_CMD_TEXELS_H

#include "shared/cmd.h"
#include "image/texels.h"

/* A texture and what its file says of it. */
struct cmd_texture {
    const struct hatch_texels *texels;
    const char *const *key_values;  /* alternating, NULL-terminated */
    const char *const *layer_names; /* of its EXR parts; NULL: slice.000 and so on */
};

/* Whether path ends in ".exr". */
bool cmd_wants_exr(const char *path);

/* Encodes a texture into file, an empty buffer: as KTX2, or, where path ends in .exr, as OpenEXR with a
 * part for each layer or slice of the finest level. A part of a 3D texture has on level l the slice that
 * its own falls into, number k >> l; levels of 1x1 texels beyond the first are left out. Plain texels
 * only for EXR. Numbers are halves, 0 to 1, and attributes the keys. Dies on failure. */
void cmd_encode_texture(struct cmd_args *args, const struct cmd_texture *texture, const char *path,
                        struct hatch_buffer *file);

#endif
