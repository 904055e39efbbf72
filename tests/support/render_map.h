/* A tonal art map of random texels. Where it is drawn with one texel per pixel (view_facing), a test can compute the
 * picture of a technique pixel by pixel. */
#ifndef HATCH_TEST_RENDER_MAP_H
#define HATCH_TEST_RENDER_MAP_H

#include <math.h>

#include "base/random.h"
#include "run.h"
#include "tam/tam.h"

/* Makes a map of 3 levels. All levels of all columns are independent, so that reading a wrong one is detected. */
static inline void random_map(uint32_t size_px, uint32_t tones, struct hatch_arena *arena, struct hatch_tam *map)
{
    struct hatch_err err;
    *map = (struct hatch_tam){
        .size_px = size_px, .tones = tones, .levels = 3, .columns = HATCH_NEW(arena, struct hatch_mipmap, tones, &err)};
    for (uint32_t t = 0; t < tones; t++) {
        struct hatch_mipmap *column = &map->columns[t];
        column->level_count = hatch_mip_chain_length(size_px, size_px);
        column->levels = HATCH_NEW(arena, struct hatch_image, column->level_count, &err);
        map->target[t] = 0.1f + 0.8f * powf((float)(t + 1) / (float)tones, 1.3f);
        for (uint32_t level = 0; level < column->level_count; level++) {
            struct hatch_image *image = &column->levels[level];
            uint32_t side = hatch_mip_size(size_px, level);
            HATCH_TEST_OK(hatch_image_make(arena, side, side, "Y", image, &err), &err);
            for (uint32_t i = 0; i < side * side; i++)
                image->pixels[i] = hatch_random_unit(7, t * 16 + level, i);
        }
    }
    map->whole = (struct hatch_tam_whole){.size_px = size_px, .tones = tones, .darkest = map->target[tones - 1]};
}

#endif
