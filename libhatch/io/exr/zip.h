/* The ZIP compression of OpenEXR's chunks: its byte filter, and zlib by libdeflate, which is
 * several times as fast as zlib and thus as OpenEXR's own. */
#ifndef HATCH_IO_EXR_ZIP_H
#define HATCH_IO_EXR_ZIP_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "image/image.h"

struct libdeflate_compressor;
struct libdeflate_decompressor;

/* Packs size bytes of raw into packed, which has room for size bytes, and returns how many it took;
 * a chunk that does not shrink is copied as it is, and size is returned. filtered: size bytes of
 * scratch. size: at least 2. */
size_t hatch_exr_zip(struct libdeflate_compressor *compressor, const uint8_t *raw, size_t size, uint8_t *filtered,
                     uint8_t *packed);

/* Unpacks what hatch_exr_zip packed to exactly size bytes of raw; false when packed is damaged.
 * filtered: size bytes of scratch. size: at least 2, and not packed_size. */
bool hatch_exr_unzip(struct libdeflate_decompressor *decompressor, const uint8_t *packed, size_t packed_size,
                     uint8_t *filtered, uint8_t *raw, size_t size);

/* How many bytes a number of a channel takes in a file. */
size_t hatch_exr_channel_bytes(enum hatch_channel_type type);

#endif
