/* Tonal art maps as the textures that engines load (tampack(1)): 8 bits a channel, linear, every
 * mip level as it was drawn. */
#ifndef HATCH_TAM_PACK_H
#define HATCH_TAM_PACK_H

#include <stdbool.h>

#include "image/texels.h"
#include "tam/tam.h"

#define HATCH_PACK_TONES_PER_TEXTURE 3u

/* How many textures hatch_tam_pack_rgb makes of a map. */
uint32_t hatch_tam_rgb_count(const struct hatch_tam *tam);

/* Three tones as red, green and blue of one 2D texture: tones 3 index .. 3 index + 2 (§5 packs six
 * into two). The texture has RGBA8, because three.js takes no RGB8; alpha is 255, and a tone beyond
 * the last is empty paper. ink_is_one: ink is 255 and paper 0, else ink is 0 and paper 255.
 * HATCH_BAD_INPUT for a coloured map. */
enum hatch_status hatch_tam_pack_rgb(const struct hatch_tam *tam, uint32_t index, bool ink_is_one,
                                     struct hatch_arena *arena, struct hatch_texels *texture,
                                     struct hatch_err *err) HATCH_MUST_USE;

/* All tones as layers of one 2D array, lightest first: R8, or RGBA8 with alpha 255 for a coloured
 * map. */
enum hatch_status hatch_tam_pack_array(const struct hatch_tam *tam, bool ink_is_one, struct hatch_arena *arena,
                                       struct hatch_texels *texture, struct hatch_err *err) HATCH_MUST_USE;

#endif
