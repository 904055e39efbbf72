/* Textures in the memory layout of a GPU: 8 bits per channel, compressed blocks, or 32-bit integers; mip-mapped; 2D, 2D
 * array or 3D. */
#ifndef HATCH_IMAGE_TEXELS_H
#define HATCH_IMAGE_TEXELS_H

#include <stdbool.h>
#include <string.h>

#include "image/image.h"

/* Format of the texels. */
enum hatch_texels_code {
    HATCH_TEXELS_PLAIN, /* UNORM, 8 bits per channel */
    HATCH_TEXELS_BC1,   /* three channels in blocks of 4x4 texels, 8 bytes each: image/block_compress.h */
    HATCH_TEXELS_BC4,   /* one channel, 8 bytes per block */
    HATCH_TEXELS_BC7,   /* three or four channels, 16 bytes per block */
    HATCH_TEXELS_R32UI  /* one unsigned integer of 32 bits, little-endian */
};

/* A texture: 2D (depth and layers 0), 2D array (layers over 0) or 3D (depth over 0). The depth of a 3D texture halves
 * with each level. */
struct hatch_texels {
    uint32_t width, height;
    uint32_t depth;    /* 0: not 3D */
    uint32_t layers;   /* 0: not an array */
    uint32_t channels; /* 1 R8, 2 RG8, 3 RGB8, 4 RGBA8; 1 with BC4 and R32UI, 3 with BC1, 4 with BC7 */
    uint32_t level_count;
    uint8_t *texels[HATCH_MIP_LEVELS_MAX]; /* per level: its layers (or slices) one after another, each row by row from
                                              the top, channels interleaved, no padding */
    enum hatch_texels_code code;
    bool srgb; /* a file said that colours are encoded as sRGB; alpha is not */
};

/* Converts 0 .. 1 to 8 bits, rounded to nearest; values outside are clamped. Clamping works on the bits of the float as
 * an integer, because gcc vectorises only this; from 0 up both have the same order. */
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

/* Return the side of a block in texels, and its size in bytes. A format without block compression has blocks of one
 * texel. */
uint32_t hatch_texels_block_side(enum hatch_texels_code code);
uint32_t hatch_texels_block_bytes(enum hatch_texels_code code, uint32_t channels);

/* Returns the size of one level in bytes, with all its layers or slices. */
size_t hatch_texels_level_size(const struct hatch_texels *texture, uint32_t level);

/* Returns the number of levels of a full mip chain, down to 1x1 or 1x1x1. */
uint32_t hatch_texels_chain_length(const struct hatch_texels *texture);

/* Allocates the levels of a texture, zeroed. All other members must be set. */
enum hatch_status hatch_texels_make(struct hatch_arena *arena, struct hatch_texels *texture,
                                    struct hatch_err *err) HATCH_MUST_USE;

/* Returns the value of a key in a file's metadata, or NULL if the key is missing.
 *   key_values  alternating keys and values, ended by NULL; NULL: an empty list */
const char *hatch_texels_value(const char *const *key_values, const char *key);

#endif
