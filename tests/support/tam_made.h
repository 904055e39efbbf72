/* Tonal art maps whose pixels are computed by a function, for tests whose results are known in closed form. */
#ifndef HATCH_TEST_TAM_MADE_H
#define HATCH_TEST_TAM_MADE_H

#include <string.h>

#include "tam/tam.h"
#include "tam_map.h"

/* Returns the reflectance, 0 .. 1, of a channel at (u, v) of a level and a tone. */
typedef float (*made_pixel)(float u, float v, uint32_t level, float tone, uint32_t channel);

/* Makes a map in map_arena. The tones of its columns rise in even steps from darkest / tones to darkest.
 *   letters  channels: "Y" or "RGB" */
static inline struct hatch_tam made_map(uint32_t size_px, uint32_t tones, float darkest, const char *letters,
                                        made_pixel pixel)
{
    static struct hatch_mipmap columns[HATCH_TAM_TONES_MAX];
    struct hatch_tam tam;
    uint32_t levels = hatch_mip_chain_length(size_px, size_px), drawn = size_px > 32 ? levels - 5 : 1;
    memset(columns, 0, sizeof columns);
    for (uint32_t tone = 0; tone < tones; tone++) {
        float target = darkest * (float)(tone + 1) / (float)tones;
        struct hatch_mipmap *column = &columns[tone];
        column->level_count = levels;
        column->levels = HATCH_NEW(&map_arena, struct hatch_image, levels, &map_err);
        for (uint32_t level = 0; level < levels; level++) {
            uint32_t size = hatch_mip_size(size_px, level);
            struct hatch_image *image = &column->levels[level];
            HATCH_TEST_OK(hatch_image_make(&map_arena, size, size, letters, image, &map_err), &map_err);
            for (size_t i = 0; i < (size_t)size * size; i++)
                for (uint32_t c = 0; c < image->channel_count; c++)
                    image->pixels[i * image->channel_count + c] =
                        pixel(((float)(i % size) + 0.5f) / (float)size, ((float)(i / size) + 0.5f) / (float)size, level,
                              target, c);
        }
        const struct hatch_tam_metadata metadata = {.tones = tones, .levels = drawn, .seed = "1", .style = "made"};
        hatch_tam_set_metadata(&metadata, tone, target, column);
    }
    HATCH_TEST_OK(hatch_tam_from_mipmaps(columns, tones, &tam, &map_err), &map_err);
    return tam;
}

/* A made_pixel for a map of plain greys instead of strokes: the reflectance of every pixel is 1 - tone. */
static inline float made_ramp(float u, float v, uint32_t level, float tone, uint32_t channel)
{
    (void)u, (void)v, (void)level, (void)channel;
    return 1 - tone;
}

#endif
