/* GPU texture files: KTX2 (Khronos, 2.0) and DDS (DX10 header), uncompressed, 8 bits a channel. */
#ifndef HATCH_IO_CONTAINER_H
#define HATCH_IO_CONTAINER_H

#include "base/bytes.h"
#include "image/image.h"

/* 2D (depth and layers 0), 2D array (layers > 0) or 3D (depth > 0), with its mip chain.
 * texels[level]: layer after layer (or slice after slice), row after row from the top, channels
 * interleaved, no padding; a 3D texture's depth halves with the level. */
struct hatch_texels {
    uint32_t width, height;
    uint32_t depth;    /* 0: not 3D */
    uint32_t layers;   /* 0: not an array */
    uint32_t channels; /* 1 R8, 2 RG8, 4 RGBA8; KTX2 also 3 RGB8 */
    uint32_t level_count;
    uint8_t *texels[HATCH_MIP_LEVELS_MAX];
};

/* Bytes of one level: all layers or slices. */
size_t hatch_texels_level_size(const struct hatch_texels *texture, uint32_t level);

/* Writes KTX2: UNORM, linear, no supercompression, with key KTXwriter and the given key/value pairs
 * (keys and values alternate, NULL-terminated; may be NULL). */
enum hatch_status hatch_ktx2_write(const struct hatch_texels *texture,
                                   const char *const *key_values, struct hatch_buffer *file,
                                   struct hatch_err *err) HATCH_MUST_USE;

/* Reads what hatch_ktx2_write writes, and any uncompressed R8, RG8, RGB8 or RGBA8 KTX2, linear or
 * sRGB (the bytes are not touched), with or without Zstandard supercompression; no cube maps, no
 * arrays of 3D textures. Sizes are checked before memory is taken: HATCH_LIMIT. */
enum hatch_status hatch_ktx2_read(struct hatch_bytes file, struct hatch_arena *arena,
                                  struct hatch_texels *texture,
                                  struct hatch_err *err) HATCH_MUST_USE;

/* Writes DDS with a DX10 header. channels: 1, 2 or 4. */
enum hatch_status hatch_dds_write(const struct hatch_texels *texture, struct hatch_buffer *file,
                                  struct hatch_err *err) HATCH_MUST_USE;

#endif
