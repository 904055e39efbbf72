#include "tam/tam.h"
#include "tam/taps.h"

static float sample_level(const struct hatch_image *image, uint32_t channels, float u, float v)
{
    struct hatch_taps taps = hatch_taps_at(u, v, image->width, image->height);
    float sum = 0;
    for (int i = 0; i < 4; i++)
        for (uint32_t c = 0; c < channels; c++)
            sum += taps.weight[i] * image->pixels[taps.texel[i] * image->channel_count + c];
    return sum / (float)channels;
}

float hatch_tam_sample(const struct hatch_tam *tam, int column, float u, float v, float lod)
{
    if (column < 0)
        return 1;
    const struct hatch_mipmap *images = &tam->columns[column];
    float share;
    uint32_t level = hatch_tap_levels(lod, images->level_count, &share), channels = tam->color ? 3 : 1;
    float finer = sample_level(&images->levels[level], channels, u, v);
    return share > 0 ? finer + share * (sample_level(&images->levels[level + 1], channels, u, v) - finer) : finer;
}
