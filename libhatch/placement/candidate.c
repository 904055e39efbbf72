#include "placement/place.h"

#include "base/random.h"

/* Returns an approximately standard normal number, the sum of twelve uniform ones minus 6, which is the same on every
 * machine and lies in -6 .. 6. */
static float normal(uint64_t seed, uint64_t stream, uint64_t index)
{
    float sum = -6;
    for (uint64_t i = 0; i < 12; i += 2) {
        uint64_t bits = hatch_random_u64(seed, stream, index + i);
        sum += (float)(bits >> 40) * 0x1p-24f + (float)(bits & 0xffffffu) * 0x1p-24f;
    }
    return sum;
}

struct hatch_stroke hatch_choice_candidate(const struct hatch_style *style, const struct hatch_choice *choice,
                                           uint32_t candidate)
{
    uint64_t index = (uint64_t)candidate * 32;
    uint64_t position = hatch_random_u64(choice->seed, choice->number, index);
    uint64_t shape = hatch_random_u64(choice->seed, choice->number, index + 1);
    float longest = choice->length_max > style->length_min ? choice->length_max : style->length_min;
    struct hatch_stroke stroke = {
        .x = (float)(position >> 40) * 0x1p-24f,
        .y = (float)(position & 0xffffffu) * 0x1p-24f,
        .length = style->length_min + (longest - style->length_min) * ((float)(shape >> 40) * 0x1p-24f),
        .width_px = style->width_px,
        .tone = style->ink,
        .level = choice->level,
        .texture_seed = (uint32_t)shape,
        .rgb = {choice->rgb[0], choice->rgb[1], choice->rgb[2]},
    };
    float jitter = style->jitter_rad > 0 ? style->jitter_rad * normal(choice->seed, choice->number, index + 2) : 0;
    if (style->bend_max_rad > 0) {
        uint64_t bend = hatch_random_u64(choice->seed, choice->number, index + 14);
        float range = style->bend_max_rad - style->bend_min_rad;
        stroke.bend_rad = style->bend_min_rad + range * ((float)(bend >> 40) * 0x1p-24f);
        stroke.bend_rad = bend & 1 ? -stroke.bend_rad : stroke.bend_rad;
    }
    stroke.angle_rad = choice->directions[candidate % choice->direction_count] + jitter;
    return stroke;
}
