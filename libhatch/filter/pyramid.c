#include "filter/pyramid.h"

#include <assert.h>

/* Returns the overlap of a fine and a coarse pixel along one axis, in fine pixels.
 *   step  fine pixels per coarse one */
static float overlap(uint32_t fine, uint32_t coarse, float step)
{
    float low = (float)coarse * step, high = low + step;
    float from = (float)fine > low ? (float)fine : low;
    float to = (float)fine + 1 < high ? (float)fine + 1 : high;
    return to > from ? to - from : 0;
}

static void halve_uneven(const struct hatch_image *fine, struct hatch_image *coarse)
{
    uint32_t channels = fine->channel_count;
    float step_x = (float)fine->width / (float)coarse->width;
    float step_y = (float)fine->height / (float)coarse->height;
    for (uint32_t y = 0; y < coarse->height; y++)
        for (uint32_t x = 0; x < coarse->width; x++)
            for (uint32_t c = 0; c < channels; c++) {
                float sum = 0;
                for (uint32_t fy = 2 * y; fy < 2 * y + 3 && fy < fine->height; fy++)
                    for (uint32_t fx = 2 * x; fx < 2 * x + 3 && fx < fine->width; fx++)
                        sum += overlap(fx, x, step_x) * overlap(fy, y, step_y) *
                               fine->pixels[((size_t)fy * fine->width + fx) * channels + c];
                coarse->pixels[((size_t)y * coarse->width + x) * channels + c] = sum / (step_x * step_y);
            }
}

void hatch_image_halve(const struct hatch_image *fine, struct hatch_image *coarse)
{
    assert(coarse->width == hatch_mip_size(fine->width, 1));
    assert(coarse->height == hatch_mip_size(fine->height, 1));
    assert(coarse->channel_count == fine->channel_count);
    if (fine->width % 2 || fine->height % 2) {
        halve_uneven(fine, coarse);
        return;
    }
    uint32_t channels = fine->channel_count;
    size_t fine_row = (size_t)fine->width * channels;
    for (uint32_t y = 0; y < coarse->height; y++) {
        const float *upper = fine->pixels + 2 * y * fine_row;
        const float *lower = upper + fine_row;
        float *out = coarse->pixels + (size_t)y * coarse->width * channels;
        for (uint32_t x = 0; x < coarse->width; x++)
            for (uint32_t c = 0; c < channels; c++) {
                size_t left = 2 * (size_t)x * channels + c, right = left + channels;
                out[x * channels + c] = ((upper[left] + upper[right]) + (lower[left] + lower[right])) * 0.25f;
            }
    }
}

enum hatch_status hatch_mipmap_complete(struct hatch_mipmap *mipmap, uint32_t first, struct hatch_arena *arena,
                                        struct hatch_err *err)
{
    assert(first >= 1);
    const struct hatch_image *finest = &mipmap->levels[0];
    uint32_t length = hatch_mip_chain_length(finest->width, finest->height);
    for (uint32_t level = first; level < length; level++) {
        const struct hatch_image *fine = &mipmap->levels[level - 1];
        struct hatch_image *coarse = &mipmap->levels[level];
        *coarse = *fine;
        coarse->width = hatch_mip_size(fine->width, 1);
        coarse->height = hatch_mip_size(fine->height, 1);
        HATCH_TRY(
            HATCH_ALLOC(arena, &coarse->pixels, (size_t)coarse->width * coarse->height * coarse->channel_count, err));
        hatch_image_halve(fine, coarse);
    }
    mipmap->level_count = length;
    return HATCH_OK;
}
