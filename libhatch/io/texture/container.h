/* Files of GPU textures: KTX2 (Khronos, 2.0) of every enum hatch_texels_code is read and written; DDS (DX10 header) of
 * 8 bits per channel is written. */
#ifndef HATCH_IO_TEXTURE_CONTAINER_H
#define HATCH_IO_TEXTURE_CONTAINER_H

#include "base/bytes.h"
#include "image/texels.h"

/* Returns whether a file begins like a KTX2 texture. */
bool hatch_ktx2_is(struct hatch_bytes file);

/* Writes a KTX2 file: UNORM or UINT, linear, without supercompression. The keys KTXwriter and KTXorientation are added.
 *   key_values  other keys and their values, alternating, at most 14 pairs, NULL-terminated; may be NULL
 *   file        out: empty buffer; stays empty on failure */
enum hatch_status hatch_ktx2_write(const struct hatch_texels *texture, const char *const *key_values,
                                   struct hatch_buffer *file, struct hatch_err *err) HATCH_MUST_USE;

/* Reads a KTX2 file of format R8, RG8, RGB8, RGBA8, BC1, BC4 or BC7, linear or sRGB (values are not
 * converted; texture->srgb tells), or R32UI, with or without Zstandard supercompression.
 * Rows that run from the bottom up, which the key KTXorientation tells (ru, rui), are turned.
 *   texture  out: texels in arena
 * HATCH_BAD_INPUT for other formats and orientations, blocks from the bottom up, cube maps, arrays of 3D textures, and
 * truncated or damaged files; HATCH_LIMIT, before any allocation, when the texels exceed the arena's limit. */
enum hatch_status hatch_ktx2_read(struct hatch_bytes file, struct hatch_arena *arena, struct hatch_texels *texture,
                                  struct hatch_err *err) HATCH_MUST_USE;

/* Reads the pairs of key and value of a KTX2 file; pairs whose value is not text are left out.
 *   key_values  out: keys and values alternating, NULL-terminated, in arena
 * HATCH_BAD_INPUT for a truncated or damaged file. */
enum hatch_status hatch_ktx2_read_keys(struct hatch_bytes file, struct hatch_arena *arena,
                                       const char *const **key_values, struct hatch_err *err) HATCH_MUST_USE;

/* Writes a DDS file with a DX10 header.
 *   texture  of code HATCH_TEXELS_PLAIN, with 1, 2 or 4 channels
 *   file     out: empty buffer; stays empty on failure */
enum hatch_status hatch_dds_write(const struct hatch_texels *texture, struct hatch_buffer *file,
                                  struct hatch_err *err) HATCH_MUST_USE;

#endif
