/* Textures as a GPU takes them: 8 bits a channel, or packed in blocks, or whole numbers; mip-mapped, of
 * two dimensions, in layers, or of three. */
#ifndef HATCH_IMAGE_TEXELS_H
#define HATCH_IMAGE_TEXELS_H

#include <string.h>

#include "image/image.h"

enum hatch_texels_code {
    HATCH_TEXELS_PLAIN, /* UNORM, 8 bits a channel */
    HATCH_TEXELS_BC1,   /* three channels in blocks of 4x4 texels, 8 bytes each: image/blocks.h */
    HATCH_TEXELS_BC4,   /* one channel, 8 bytes a block */
    HATCH_TEXELS_BC7,   /* three or four channels, 16 bytes a block */
    HATCH_TEXELS_R32UI  /* one whole number of 32 bits, little-endian */
};

/* 2D (depth and layers 0), 2D array (layers > 0) or 3D (depth > 0), with its mip chain.
 * texels[level]: layer after layer (or slice after slice), row after row from the top, channels
 * interleaved, no padding; a 3D texture's depth halves with the level. */
struct hatch_texels {
    uint32_t width, height;
    uint32_t depth;    /* 0: not 3D */
    uint32_t layers;   /* 0: not an array */
    uint32_t channels; /* 1 R8, 2 RG8, 3 RGB8, 4 RGBA8; 1 with BC4 and R32UI, 3 with BC1,
                          4 with BC7 */
    uint32_t level_count;
    uint8_t *texels[HATCH_MIP_LEVELS_MAX];
    enum hatch_texels_code code;
};

/* 0 .. 1 as eight bits, rounded to nearest; what lies outside is cut off. The bits of floats that are not
 * negative are in the order of their values; selections are made with masks, because gcc makes vector code
 * of nothing else. */
static inline uint8_t hatch_unorm8(float value)
{
    int32_t bits, one = 0x3f800000;
    memcpy(&bits, &value, sizeof bits);
    bits &= ~(bits >> 31);
    int32_t over = -(int32_t)(bits > one);
    bits = (bits & ~over) | (one & over);
    memcpy(&value, &bits, sizeof value);
    return (uint8_t)(int32_t)(value * 255 + 0.5f);
}

/* A block's texels each way, and its bytes; of what is not packed in blocks it is one texel. */
uint32_t hatch_texels_block_side(enum hatch_texels_code code);
uint32_t hatch_texels_block_bytes(enum hatch_texels_code code, uint32_t channels);

/* Bytes of one level: all layers or slices. */
size_t hatch_texels_level_size(const struct hatch_texels *texture, uint32_t level);

/* How many levels a full chain has: down to 1x1, or 1x1x1. */
uint32_t hatch_texels_chain_length(const struct hatch_texels *texture);

/* Gives every level its zeroed bytes in arena; the other fields are set, levels by level_count. */
enum hatch_status hatch_texels_make(struct hatch_arena *arena, struct hatch_texels *texture,
                                    struct hatch_err *err) HATCH_MUST_USE;

/* The value of a key in what a file says of its texture, or NULL. key_values: keys and values alternate, a
 * NULL ends them; NULL is an empty list. */
const char *hatch_texels_value(const char *const *key_values, const char *key);

#endif
