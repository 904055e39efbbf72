#include "tam/pack.h"

#include <assert.h>

#define FULL 255u

static uint8_t encode_texel(float reflectance, bool ink_is_one)
{
    return hatch_unorm8(ink_is_one ? 1 - reflectance : reflectance);
}

/* Writes channel c of a level to every stride-th byte of out. */
static void pack_channel(const struct hatch_image *image, uint32_t c, bool ink_is_one, uint8_t *out, size_t stride)
{
    size_t texels = (size_t)image->width * image->height;
    const float *in = image->pixels + c;
    for (size_t i = 0; i < texels; i++, in += image->channel_count, out += stride)
        *out = encode_texel(*in, ink_is_one);
}

static void fill(size_t texels, uint8_t value, uint8_t *out, size_t stride)
{
    for (size_t i = 0; i < texels; i++, out += stride)
        *out = value;
}

uint32_t hatch_tam_rgb_count(const struct hatch_tam *tam)
{
    return (tam->tones + HATCH_PACK_TONES_PER_TEXTURE - 1) / HATCH_PACK_TONES_PER_TEXTURE;
}

enum hatch_status hatch_tam_pack_rgb(const struct hatch_tam *tam, uint32_t index, bool ink_is_one,
                                     struct hatch_arena *arena, struct hatch_texels *texture, struct hatch_err *err)
{
    assert(index < hatch_tam_rgb_count(tam));
    if (tam->color)
        return hatch_fail(err, HATCH_BAD_INPUT,
                          "the map is coloured, want grey: each channel of the texture holds one tone");
    struct hatch_texels made = {
        .width = tam->size_px, .height = tam->size_px, .channels = 4, .level_count = tam->columns[0].level_count};
    HATCH_TRY(hatch_texels_make(arena, &made, err));
    uint8_t paper = encode_texel(1, ink_is_one);
    for (uint32_t level = 0; level < made.level_count; level++) {
        size_t texels = hatch_texels_level_size(&made, level) / made.channels;
        for (uint32_t c = 0; c < HATCH_PACK_TONES_PER_TEXTURE; c++) {
            uint32_t tone = index * HATCH_PACK_TONES_PER_TEXTURE + c;
            if (tone < tam->tones)
                pack_channel(&tam->columns[tone].levels[level], 0, ink_is_one, made.texels[level] + c, made.channels);
            else
                fill(texels, paper, made.texels[level] + c, made.channels);
        }
        fill(texels, FULL, made.texels[level] + 3, made.channels);
    }
    *texture = made;
    return HATCH_OK;
}

enum hatch_status hatch_tam_pack_array(const struct hatch_tam *tam, bool ink_is_one, struct hatch_arena *arena,
                                       struct hatch_texels *texture, struct hatch_err *err)
{
    struct hatch_texels made = {.width = tam->size_px,
                                .height = tam->size_px,
                                .layers = tam->tones,
                                .channels = tam->color ? 4 : 1,
                                .level_count = tam->columns[0].level_count};
    HATCH_TRY(hatch_texels_make(arena, &made, err));
    for (uint32_t level = 0; level < made.level_count; level++) {
        size_t layer = hatch_texels_level_size(&made, level) / made.layers;
        for (uint32_t tone = 0; tone < tam->tones; tone++) {
            const struct hatch_image *image = &tam->columns[tone].levels[level];
            uint8_t *out = made.texels[level] + tone * layer;
            for (uint32_t c = 0; c < (tam->color ? 3 : 1); c++)
                pack_channel(image, c, ink_is_one, out + c, made.channels);
            if (tam->color)
                fill(layer / made.channels, FULL, out + 3, made.channels);
        }
    }
    *texture = made;
    return HATCH_OK;
}
