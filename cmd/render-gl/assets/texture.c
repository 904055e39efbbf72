#include "render-gl/assets/texture.h"

#include <string.h>

#include "image/block_compress.h"
#include "io/texture/container.h"
#include "tam/thresholds.h"
#include "tam/volume.h"
#include "tam/whole.h"

/* Returns the darkest tone of a threshold texture: the mean, over all texels, of the sum of a texel's steps. */
static float darkest_of(const struct hatch_thresholds *thresholds)
{
    const struct hatch_texels *texels = &thresholds->texels;
    size_t count = (size_t)texels->width * texels->height;
    const uint8_t *dy0 = texels->texels[0] + 2 * count * texels->layers; /* the second half of the layers */
    uint64_t sum = 0;
    for (size_t i = 0; i < 2 * count * texels->layers; i++)
        sum += i < 4 * count || i % 4 < 3 ? dy0[i] : 0u;
    return (float)((double)sum / (255.0 * (double)count));
}

static enum hatch_status read_thresholds(const char *const *key_values, struct hatch_arena *arena,
                                         struct tone_texture *texture, struct hatch_err *err)
{
    struct hatch_thresholds thresholds;
    HATCH_TRY(hatch_thresholds_decompress(&texture->texels, arena, &texture->texels, err));
    HATCH_TRY(hatch_thresholds_from_texels(&texture->texels, key_values, &thresholds, err));
    texture->holds = TONE_TEXTURE_THRESHOLDS;
    texture->levels = thresholds.levels;
    texture->darkest = darkest_of(&thresholds);
    return HATCH_OK;
}

static enum hatch_status read_exact(struct tone_texture *texture, struct hatch_err *err)
{
    HATCH_TRY(hatch_exact_from_texels(&texture->texels, &texture->exact, err));
    texture->holds = TONE_TEXTURE_RUNS;
    texture->size_px = texture->exact.size_px;
    texture->levels = texture->exact.levels;
    texture->darkest = hatch_exact_tone(&texture->exact, texture->exact.columns - 1);
    return HATCH_OK;
}

/* Reads a volume. Compressed texels are decompressed here for validation only; the GPU receives them as they are. */
static enum hatch_status read_volume(const char *const *key_values, struct hatch_arena *scratch,
                                     struct tone_texture *texture, struct hatch_err *err)
{
    struct hatch_arena_mark mark = hatch_arena_mark(scratch);
    struct hatch_texels plain;
    struct hatch_volume volume;
    enum hatch_status status = hatch_texels_decompress(&texture->texels, scratch, &plain, err);
    if (status == HATCH_OK)
        status = hatch_volume_from_texels(&plain, key_values, &volume, err);
    hatch_arena_rewind(scratch, mark);
    HATCH_TRY(status);
    texture->holds = TONE_TEXTURE_VOLUME;
    texture->levels = volume.levels;
    texture->darkest = volume.darkest;
    texture->top = volume.top;
    return HATCH_OK;
}

enum hatch_status tone_texture_read(struct hatch_bytes file, struct hatch_arena *arena, struct hatch_arena *scratch,
                                    struct tone_texture *texture, struct hatch_err *err)
{
    struct tone_texture made = {0};
    const char *const *key_values;
    HATCH_TRY(hatch_ktx2_read(file, arena, &made.texels, err));
    HATCH_TRY(hatch_ktx2_read_keys(file, arena, &key_values, err));
    made.size_px = made.texels.width;
    if (made.texels.code == HATCH_TEXELS_R32UI)
        HATCH_TRY(read_exact(&made, err));
    else if (hatch_texels_value(key_values, HATCH_THRESHOLD_KEY_BORDERS))
        HATCH_TRY(read_thresholds(key_values, arena, &made, err));
    else if (hatch_texels_value(key_values, HATCH_VOLUME_KEY_DARKEST))
        HATCH_TRY(read_volume(key_values, scratch, &made, err));
    else
        return hatch_fail(err, HATCH_BAD_INPUT,
                          "the texture is neither a volume nor thresholds nor exact runs: "
                          "tamvol or tamthresh makes one");
    HATCH_TRY(hatch_tam_whole_read(key_values, made.size_px, &made.whole, &made.last, err));
    if (made.whole.tolerance > 0)
        made.darkest = made.whole.darkest;
    *texture = made;
    return HATCH_OK;
}
