/* Textures as a GPU takes them: 8 bits a channel, mip-mapped, of two dimensions, in layers, or of
 * three. */
#ifndef HATCH_IMAGE_TEXELS_H
#define HATCH_IMAGE_TEXELS_H

#include "image/image.h"

/* 2D (depth and layers 0), 2D array (layers > 0) or 3D (depth > 0), with its mip chain.
 * texels[level]: layer after layer (or slice after slice), row after row from the top, channels
 * interleaved, no padding; a 3D texture's depth halves with the level. */
struct hatch_texels {
    uint32_t width, height;
    uint32_t depth;    /* 0: not 3D */
    uint32_t layers;   /* 0: not an array */
    uint32_t channels; /* 1 R8, 2 RG8, 3 RGB8, 4 RGBA8 */
    uint32_t level_count;
    uint8_t *texels[HATCH_MIP_LEVELS_MAX];
};

/* Bytes of one level: all layers or slices. */
size_t hatch_texels_level_size(const struct hatch_texels *texture, uint32_t level);

/* How many levels a full chain has: down to 1x1, or 1x1x1. */
uint32_t hatch_texels_chain_length(const struct hatch_texels *texture);

/* Gives every level its zeroed bytes in arena; the other fields are set. */
enum hatch_status hatch_texels_make(struct hatch_arena *arena, struct hatch_texels *texture,
                                    struct hatch_err *err) HATCH_MUST_USE;

#endif
