/* Block compression of textures, 4x4 texels a block: BC1 (S3TC) of RGB, 8 bytes a block, BC4 (RGTC1) of one
 * channel, 8 bytes, and BC7 (BPTC) of RGB or RGBA, 16 bytes, in its mode 6. (Khronos Data Format
 * Specification 1.3, sections 18, 20.4 and 21; OpenGL 4.5, appendix D.)
 * Edges that are no multiple of 4 repeat their last texel. */
#ifndef HATCH_IMAGE_BLOCKS_H
#define HATCH_IMAGE_BLOCKS_H

#include "base/parallel.h"
#include "image/texels.h"

/* Of channels, 0 .. 1, over all levels. */
struct hatch_block_figures {
    double error_max, error_rms;
};

/* Packs a plain texture, R8 to BC4, RGB8 or RGBA8 to BC7, whose alpha becomes 254 or 255, or to BC1, which has
 * none. pool: NULL is one thread; the result is the same. figures: may be NULL. */
enum hatch_status hatch_texels_pack(const struct hatch_texels *plain, enum hatch_texels_code code,
                                    struct hatch_pool *pool, struct hatch_arena *arena, struct hatch_texels *packed,
                                    struct hatch_block_figures *figures, struct hatch_err *err) HATCH_MUST_USE;

/* Unpacks BC1 to RGB8, BC4 to R8 and BC7 to RGBA8, as a GPU would, rounded to 8 bits; a plain texture is taken as it
 * is (nothing is copied). HATCH_BAD_INPUT names a BC7 block of another mode than 6. */
enum hatch_status hatch_texels_unpack(const struct hatch_texels *packed, struct hatch_arena *arena,
                                      struct hatch_texels *plain, struct hatch_err *err) HATCH_MUST_USE;

#endif
