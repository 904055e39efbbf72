#include "curve/stroke_look.h"

#include <math.h>
#include <string.h>

#include "curve/hash.h"

double hatch_profile_at(const struct hatch_profile *profile, double at)
{
    if (!profile->count)
        return 1;
    double place = fmin(fmax(at, 0), 1) * (profile->count - 1);
    uint32_t low = (uint32_t)fmin(place, profile->count - 2);
    double before = (double)profile->values[low], after = (double)profile->values[low + 1];
    return before + (place - low) * (after - before);
}

double hatch_profile_mean(const struct hatch_profile *profile)
{
    double sum = 0;
    if (!profile->count)
        return 1;
    for (uint32_t i = 0; i < profile->count; i++)
        sum += (double)profile->values[i] * (i == 0 || i + 1 == profile->count ? 0.5 : 1);
    return sum / (profile->count - 1);
}

/* Returns a triangle wave of length 1, from 0 upwards. */
static double triangle(double at)
{
    double from = at - 0.25;
    return 4 * fabs(from - floor(from) - 0.5) - 1;
}

double hatch_zigzag_beside(double at, double level)
{
    double low = floor(level), waves = at * exp2(low), part = fmin(fmax(2 * (level - low) - 0.5, 0), 1);
    return (1 - part) * triangle(waves) + part * triangle(2 * waves);
}

double hatch_zigzag_turn(double at, double level)
{
    const double quarter = exp2(-floor(level)) / (level > floor(level) ? 8 : 4);
    return quarter * (floor(at / quarter + 1e-6) + 1);
}

double hatch_zigzag_stretch(const struct hatch_stroke_look *look)
{
    return look->zigzag > 0 ? hypot(1, 4 * (double)look->zigzag / (double)look->zigzag_length) : 1;
}

void hatch_stroke_color(const struct hatch_stroke_look *look, uint32_t id, float rgb[3])
{
    const uint32_t draw = hatch_mix_bits((id & HATCH_STROKE_NUMBER_BITS) ^ 0x3c6ef372u) >> 8;
    if (!look->mixes) {
        memcpy(rgb, look->colors[draw * look->color_count >> 24], 3 * sizeof *rgb);
        return;
    }
    float place = (float)draw / 16777216.0f * (float)(look->color_count - 1);
    uint32_t low = (uint32_t)place;
    for (int k = 0; k < 3; k++) {
        float before = look->colors[low][k], after = look->colors[low + 1][k];
        rgb[k] = before + (place - (float)low) * (after - before);
    }
}
