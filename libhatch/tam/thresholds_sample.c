#include <assert.h>
#include <stdlib.h>
#include <string.h>

#include "tam/taps.h"
#include "tam/thresholds.h"

enum hatch_status hatch_thresholds_from_texels(const struct hatch_texels *texels, const char *const *key_values,
                                               struct hatch_thresholds *thresholds, struct hatch_err *err)
{
    const char *levels = hatch_texels_value(key_values, HATCH_TAM_ATTR_LEVELS);
    const char *borders = hatch_texels_value(key_values, HATCH_THRESHOLD_KEY_BORDERS);
    if (texels->code != HATCH_TEXELS_PLAIN || texels->channels != 4 || !levels || !borders ||
        (texels->layers != HATCH_THRESHOLD_LAYERS && texels->layers != HATCH_THRESHOLD_LAYERS_FEW))
        return hatch_fail(err, HATCH_BAD_INPUT, "not threshold textures as described in tamthresh(5)");
    struct hatch_thresholds made = {.texels = *texels, .levels = (uint32_t)strtoul(levels, NULL, 10)};
    if (made.levels < 1 || made.levels > texels->level_count)
        return hatch_fail(err, HATCH_BAD_INPUT, HATCH_TAM_ATTR_LEVELS " %s, want 1 to %u", levels, texels->level_count);
    const char *at = borders;
    uint32_t count = 0;
    for (char *end; count <= HATCH_THRESHOLD_BINS; count++, at = end) {
        made.border[count] = strtof(at, &end);
        if (end == at)
            break;
        if (!(made.border[count] >= (count ? made.border[count - 1] : 0) && made.border[count] <= 1))
            return hatch_fail(err, HATCH_BAD_INPUT,
                              HATCH_THRESHOLD_KEY_BORDERS " '%s', want rising numbers from 0 to 1", borders);
    }
    if (count < 2)
        return hatch_fail(err, HATCH_BAD_INPUT, HATCH_THRESHOLD_KEY_BORDERS " '%s', want 2 numbers or more", borders);
    made.bins = count - 1;
    if (texels->layers == HATCH_THRESHOLD_LAYERS_FEW && made.bins > HATCH_THRESHOLD_BINS_FEW)
        return hatch_fail(err, HATCH_BAD_INPUT, "%u bins in %u layers, want %u at most", made.bins, texels->layers,
                          HATCH_THRESHOLD_BINS_FEW);
    *thresholds = made;
    return HATCH_OK;
}

/* Adds the filtered steps of a level, times weight. */
static void add_level(const struct hatch_texels *texels, uint32_t level, float u, float v, float weight, float x[8],
                      float height[8])
{
    uint32_t width = hatch_mip_size(texels->width, level), rows = hatch_mip_size(texels->height, level);
    size_t layer = (size_t)width * rows * 4;
    struct hatch_taps taps = hatch_taps_at(u, v, width, rows);
    for (int tap = 0; tap < 4; tap++)
        for (uint32_t i = 0; i < 2 * texels->layers; i++) {
            const uint8_t *texel = texels->texels[level] + i / 4 * layer + taps.texel[tap] * 4 + i % 4;
            x[i] += weight * taps.weight[tap] * (float)texel[0] / 255;
            height[i] += weight * taps.weight[tap] * (float)texel[texels->layers / 2 * layer] / 255;
        }
}

float hatch_thresholds_sample(const struct hatch_thresholds *thresholds, float u, float v, float tone, float lod)
{
    float x[8] = {0}, height[8] = {0}, share, darkness = 0;
    uint32_t level = hatch_tap_levels(lod, thresholds->texels.level_count, &share);
    add_level(&thresholds->texels, level, u, v, 1 - share, x, height);
    if (share > 0)
        add_level(&thresholds->texels, level + 1, u, v, share, x, height);
    for (uint32_t bin = 0; bin < HATCH_THRESHOLD_BINS; bin++)
        darkness += tone > x[bin] ? height[bin] : 0;
    return darkness < 1 ? 1 - darkness : 0;
}

void hatch_thresholds_pack(struct hatch_thresholds *thresholds)
{
    struct hatch_texels *texels = &thresholds->texels;
    assert(thresholds->bins <= HATCH_THRESHOLD_BINS_FEW && texels->layers == HATCH_THRESHOLD_LAYERS);
    for (uint32_t level = 0; level < texels->level_count; level++) {
        size_t layer = 4 * (size_t)hatch_mip_size(texels->width, level) * hatch_mip_size(texels->height, level);
        memcpy(texels->texels[level] + layer, texels->texels[level] + HATCH_THRESHOLD_DY0 * layer, layer);
    }
    texels->layers = HATCH_THRESHOLD_LAYERS_FEW;
}
