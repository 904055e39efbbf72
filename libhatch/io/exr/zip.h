/* ZIP compression of OpenEXR's chunks: the format's byte filter, and zlib streams made by libdeflate, which is several
 * times as fast as the zlib that OpenEXR uses. */
#ifndef HATCH_IO_EXR_ZIP_H
#define HATCH_IO_EXR_ZIP_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "image/image.h"

struct libdeflate_compressor;
struct libdeflate_decompressor;

/* Compresses a chunk and returns its compressed size; a chunk that does not shrink is copied unchanged
 * and size is returned.
 *   size      bytes of raw, at least 2
 *   filtered  size bytes of scratch
 *   packed    out: room for size bytes */
size_t hatch_exr_zip(struct libdeflate_compressor *compressor, const uint8_t *raw, size_t size, uint8_t *filtered,
                     uint8_t *packed);

/* Decompresses a chunk that was compressed like those of hatch_exr_zip. Returns false when packed is damaged.
 *   packed_size  not equal to size: a chunk of size bytes is not compressed, and the caller copies it
 *   filtered     size bytes of scratch
 *   raw          out: exactly size bytes, at least 2 */
bool hatch_exr_unzip(struct libdeflate_decompressor *decompressor, const uint8_t *packed, size_t packed_size,
                     uint8_t *filtered, uint8_t *raw, size_t size);

/* Returns the bytes that one value of a channel takes in a file. */
size_t hatch_exr_channel_bytes(enum hatch_channel_type type);

#endif
