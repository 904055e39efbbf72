#include <math.h>
#include <stdlib.h>

#include "tam/taps.h"
#include "tam/volume.h"

enum hatch_status hatch_volume_from_texels(const struct hatch_texels *texels, const char *const *key_values,
                                           struct hatch_volume *volume, struct hatch_err *err)
{
    const char *levels = hatch_texels_value(key_values, HATCH_TAM_ATTR_LEVELS);
    const char *darkest = hatch_texels_value(key_values, HATCH_VOLUME_KEY_DARKEST);
    if (texels->code != HATCH_TEXELS_PLAIN || (!texels->depth && !texels->layers) || !levels || !darkest)
        return hatch_fail(err, HATCH_BAD_INPUT, "not a volume as described in tamvol(5)");
    const char *top = hatch_texels_value(key_values, HATCH_VOLUME_KEY_TOP);
    struct hatch_volume made = {*texels, (uint32_t)strtoul(levels, NULL, 10), strtof(darkest, NULL),
                                top ? strtof(top, NULL) : 1};
    if (!(made.top > 0 && made.top <= 1))
        return hatch_fail(err, HATCH_BAD_INPUT, HATCH_VOLUME_KEY_TOP " '%s', want a number over 0, at most 1", top);
    if (made.levels < 1 || made.levels > texels->level_count || !(made.darkest >= 0 && made.darkest <= 1))
        return hatch_fail(err, HATCH_BAD_INPUT,
                          HATCH_TAM_ATTR_LEVELS " %s or " HATCH_VOLUME_KEY_DARKEST
                                                " %s is out of range: want 1 to %u and 0 to 1",
                          levels, darkest, texels->level_count);
    *volume = made;
    return HATCH_OK;
}

/* Returns one channel of a level, interpolated linearly between the two slices around a tone and clamped to the first
 * and the last. */
static float sample_level(const struct hatch_texels *texels, uint32_t level, uint32_t depth,
                          const struct hatch_taps *taps, float tone, uint32_t channel)
{
    size_t plane = (size_t)hatch_mip_size(texels->width, level) * hatch_mip_size(texels->height, level);
    float last = (float)(depth - 1), position = tone * (float)depth - 0.5f, sum = 0;
    position = position > 0 ? (position < last ? position : last) : 0;
    uint32_t slice = (uint32_t)position, next = slice + 1 < depth ? slice + 1 : slice;
    float share = position - (float)slice;
    const uint8_t *below = texels->texels[level] + slice * plane * texels->channels + channel;
    const uint8_t *above = texels->texels[level] + next * plane * texels->channels + channel;
    for (int i = 0; i < 4; i++) {
        size_t at = taps->texel[i] * texels->channels;
        sum += taps->weight[i] * ((1 - share) * (float)below[at] + share * (float)above[at]);
    }
    return sum / 255;
}

/* Returns how far a tone is from one end of the tones in what texture units return: outermost slices stand for all
 * tones beyond them.
 *   distance   of the tone from that end
 *   outermost  of the outermost slices of two levels, which share blends */
static float distance_held(float distance, const float outermost[2], float share)
{
    float finer = fmaxf(distance, outermost[0]), coarser = fmaxf(distance, outermost[1]);
    return finer + share * (coarser - finer);
}

void hatch_volume_sample(const struct hatch_volume *volume, float u, float v, float tone, float lod, bool corrected,
                         float *value)
{
    const struct hatch_texels *texels = &volume->texels;
    float clamped = tone > 0 ? (tone < 1 ? tone : 1) : 0, share, first[2], last[2];
    uint32_t level = hatch_tap_levels(lod, texels->level_count, &share);
    for (uint32_t c = 0; c < texels->channels; c++)
        value[c] = 0;
    for (uint32_t i = 0; i < 2; i++) {
        uint32_t at = level + (share > 0 ? i : 0);
        uint32_t depth = texels->depth ? hatch_mip_size(texels->depth, at) : texels->layers;
        struct hatch_taps taps =
            hatch_taps_at(u, v, hatch_mip_size(texels->width, at), hatch_mip_size(texels->height, at));
        for (uint32_t c = 0; (!i || share > 0) && c < texels->channels; c++)
            value[c] += (i ? share : 1 - share) * sample_level(texels, at, depth, &taps, clamped / volume->top, c);
        first[i] = 0.5f * volume->top / (float)depth;
        last[i] = 1 - volume->top + first[i];
    }
    float light = 1 - fminf(clamped, volume->darkest);
    for (uint32_t c = 0; corrected && c < texels->channels && c < 3; c++) {
        value[c] = 1 + (value[c] - 1) * (clamped / distance_held(clamped, first, share));
        value[c] *= light / distance_held(light, last, share);
    }
}
