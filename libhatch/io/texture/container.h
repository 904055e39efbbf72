/* GPU texture files: KTX2 (Khronos, 2.0), of every enum hatch_texels_code, and DDS (DX10 header),
 * uncompressed, 8 bits a channel. */
#ifndef HATCH_IO_CONTAINER_H
#define HATCH_IO_CONTAINER_H

#include "base/bytes.h"
#include "image/texels.h"

/* Writes KTX2 into an empty buffer: UNORM, linear, no supercompression, with the keys KTXwriter and
 * KTXorientation and the given pairs (keys and values alternate, at most 14 pairs, NULL-terminated;
 * may be NULL). */
enum hatch_status hatch_ktx2_write(const struct hatch_texels *texture, const char *const *key_values,
                                   struct hatch_buffer *file, struct hatch_err *err) HATCH_MUST_USE;

/* Reads what hatch_ktx2_write writes, and any R8, RG8, RGB8, RGBA8, BC1, BC4, BC7 or R32UI KTX2, linear or
 * sRGB (the bytes are not touched), with or without Zstandard supercompression; no cube maps, no
 * arrays of 3D textures. HATCH_BAD_INPUT for these and for a file that is cut or damaged, with the place. Sizes are
 * checked before memory is taken: HATCH_LIMIT. */
enum hatch_status hatch_ktx2_read(struct hatch_bytes file, struct hatch_arena *arena, struct hatch_texels *texture,
                                  struct hatch_err *err) HATCH_MUST_USE;

/* The key and value pairs of a KTX2 file whose values are text: keys and values alternate, and a NULL
 * ends them. Pairs that hold other bytes are left out. */
enum hatch_status hatch_ktx2_read_keys(struct hatch_bytes file, struct hatch_arena *arena,
                                       const char *const **key_values, struct hatch_err *err) HATCH_MUST_USE;

/* Writes DDS with a DX10 header into an empty buffer. channels: 1, 2 or 4. */
enum hatch_status hatch_dds_write(const struct hatch_texels *texture, struct hatch_buffer *file,
                                  struct hatch_err *err) HATCH_MUST_USE;

#endif
