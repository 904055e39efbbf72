/* Packs tonal art maps into the textures that engines load (tampack(1)): 8 bits per channel, linear, every
 * mip level as it was drawn. */
#ifndef HATCH_TAM_PACK_H
#define HATCH_TAM_PACK_H

#include <stdbool.h>

#include "image/texels.h"
#include "tam/tam.h"

#define HATCH_PACK_TONES_PER_TEXTURE 3u

/* Returns the number of textures that hatch_tam_pack_rgb makes of a map. */
uint32_t hatch_tam_rgb_count(const struct hatch_tam *tam);

/* Packs three tones into red, green and blue of one 2D texture (Praun et al. 2001, §5, packs six tones into two
 * textures). The format is RGBA8, because three.js does not load RGB8; alpha is 255.
 *   index       number of the texture, 0 .. hatch_tam_rgb_count - 1; it holds the tones 3 index .. 3 index + 2, with
 *               paper in place of tones beyond the last
 *   ink_is_one  true: ink is 255 and paper 0; false: ink is 0 and paper 255
 *   texture     out, in arena
 * HATCH_BAD_INPUT for a map in colour. */
enum hatch_status hatch_tam_pack_rgb(const struct hatch_tam *tam, uint32_t index, bool ink_is_one,
                                     struct hatch_arena *arena, struct hatch_texels *texture,
                                     struct hatch_err *err) HATCH_MUST_USE;

/* Packs all tones into the layers of one 2D array, lightest first: R8, or RGBA8 with alpha 255 for a map in
 * colour. Arguments as for hatch_tam_pack_rgb. */
enum hatch_status hatch_tam_pack_array(const struct hatch_tam *tam, bool ink_is_one, struct hatch_arena *arena,
                                       struct hatch_texels *texture, struct hatch_err *err) HATCH_MUST_USE;

#endif
