#include "tam/style.h"

#include <math.h>

void hatch_style_default(struct hatch_style *style)
{
    *style = (struct hatch_style){
        .name = "ink",
        .brush = HATCH_BRUSH_INK,
        .width_px = 1.8f,
        .length_min = 0.3f,
        .length_max = 1.0f,
        .jitter_rad = 0.015f,
        .ink = 1,
        .overlap_darkens = true,
        .tone_max = 0.9f,
        .tone_gamma = 1,
        .direction_count = 3,
        .directions = {{0, 0, 0.5f}, {1.5707963f, 0.5f, 1}, {0, 0.8f, 1}},
        .candidates_light = 1000,
        .candidates_dark = 100,
    };
}

void hatch_style_targets(const struct hatch_style *style, uint32_t tones, float *target)
{
    for (uint32_t i = 0; i < tones; i++) {
        double share = (double)(i + 1) / (double)tones;
        target[i] = (float)((double)style->tone_max * pow(share, (double)style->tone_gamma));
    }
}
