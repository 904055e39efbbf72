#include <assert.h>

#include "tam/thresholds.h"

#define CHANNELS 4u
#define BLOCKS HATCH_THRESHOLD_LAYERS_BLOCKS

static size_t texels_of(const struct hatch_texels *texels, uint32_t level)
{
    return (size_t)hatch_mip_size(texels->width, level) * hatch_mip_size(texels->height, level);
}

/* Returns the first value of a channel of thresholds in two layers; the next is CHANNELS farther.
 *   channel  0 .. BLOCKS - 1 */
static uint8_t *channel_at(const struct hatch_texels *texels, uint32_t level, uint32_t channel)
{
    return texels->texels[level] + channel / CHANNELS * CHANNELS * texels_of(texels, level) + channel % CHANNELS;
}

enum hatch_status hatch_thresholds_compress(const struct hatch_thresholds *thresholds, struct hatch_pool *pool,
                                            struct hatch_arena *arena, struct hatch_texels *packed,
                                            struct hatch_block_figures *figures, struct hatch_err *err)
{
    const struct hatch_texels *texels = &thresholds->texels;
    assert(texels->layers == HATCH_THRESHOLD_LAYERS_FEW && texels->channels == CHANNELS);
    struct hatch_texels plain = *texels;
    plain.channels = 1;
    plain.layers = BLOCKS;
    HATCH_TRY(hatch_texels_make(arena, &plain, err));
    for (uint32_t level = 0; level < texels->level_count; level++) {
        size_t count = texels_of(texels, level);
        for (uint32_t channel = 0; channel < BLOCKS; channel++) {
            const uint8_t *from = channel_at(texels, level, channel);
            uint8_t *to = plain.texels[level] + channel * count;
            for (size_t i = 0; i < count; i++)
                to[i] = from[CHANNELS * i];
        }
    }
    return hatch_texels_compress(&plain, HATCH_TEXELS_BC4, pool, arena, packed, figures, err);
}

enum hatch_status hatch_thresholds_decompress(const struct hatch_texels *file, struct hatch_arena *arena,
                                              struct hatch_texels *texels, struct hatch_err *err)
{
    struct hatch_texels plain, made = *file;
    if (file->code != HATCH_TEXELS_BC4) {
        *texels = made;
        return HATCH_OK;
    }
    if (file->layers != BLOCKS)
        return hatch_fail(err, HATCH_BAD_INPUT, "thresholds in blocks have %u layers, want %u", file->layers, BLOCKS);
    HATCH_TRY(hatch_texels_decompress(file, arena, &plain, err));
    made.code = HATCH_TEXELS_PLAIN;
    made.channels = CHANNELS;
    made.layers = HATCH_THRESHOLD_LAYERS_FEW;
    HATCH_TRY(hatch_texels_make(arena, &made, err));
    for (uint32_t level = 0; level < made.level_count; level++) {
        size_t count = texels_of(&made, level);
        for (uint32_t channel = 0; channel < BLOCKS; channel++) {
            const uint8_t *from = plain.texels[level] + channel * count;
            uint8_t *to = channel_at(&made, level, channel);
            for (size_t i = 0; i < count; i++)
                to[CHANNELS * i] = from[i];
        }
    }
    *texels = made;
    return HATCH_OK;
}
