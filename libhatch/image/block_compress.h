/* Block compression of textures, 4x4 texels per block: BC1 (S3TC) for RGB, 8 bytes per block; BC4 (RGTC1) for one
 * channel, 8 bytes per block; and BC7 (BPTC) for RGB or RGBA, 16 bytes per block, mode 6 only (Khronos Data Format
 * Specification 1.3, sections 18, 20.4 and 21; OpenGL 4.5, appendix D). Where a block extends beyond the texture, the
 * last row or column of the texture is repeated. */
#ifndef HATCH_IMAGE_BLOCK_COMPRESS_H
#define HATCH_IMAGE_BLOCK_COMPRESS_H

#include "base/parallel.h"
#include "image/texels.h"

/* Compression error over all channels of all levels, 0 .. 1. */
struct hatch_block_figures {
    double error_max, error_rms;
};

/* Compresses a texture.
 *   plain    HATCH_TEXELS_PLAIN: R8 for BC4; RGB8 or RGBA8 for BC1, which drops alpha, and for BC7, which replaces
 *            alpha by 254 or 255
 *   code     HATCH_TEXELS_BC1, HATCH_TEXELS_BC4 or HATCH_TEXELS_BC7
 *   pool     NULL: one thread; the result is the same
 *   packed   out, in arena; unchanged on failure
 *   figures  out; may be NULL */
enum hatch_status hatch_texels_compress(const struct hatch_texels *plain, enum hatch_texels_code code,
                                        struct hatch_pool *pool, struct hatch_arena *arena, struct hatch_texels *packed,
                                        struct hatch_block_figures *figures, struct hatch_err *err) HATCH_MUST_USE;

/* Decompresses BC1 to RGB8, BC4 to R8 and BC7 to RGBA8, as a GPU does, rounded to 8 bits.
 *   packed  a plain texture is returned as it is, without a copy
 *   plain   out, in arena; unchanged on failure
 * HATCH_BAD_INPUT for HATCH_TEXELS_R32UI, and for a BC7 block of a mode other than 6; the message then names the
 * level. */
enum hatch_status hatch_texels_decompress(const struct hatch_texels *packed, struct hatch_arena *arena,
                                          struct hatch_texels *plain, struct hatch_err *err) HATCH_MUST_USE;

#endif
