// Exact runs: the complete step function of each texel over tone (tamthresh(5)). The functions of the four texels
// around a place, in two mip levels, are evaluated and the results blended; the steps themselves are never
// interpolated.
#include "tones/targets.glsl"
#include "tones/tones.glsl"

// Returns the tone half-way between a column and the one before it.
float half_before(uint column)
{
    return 0.5 * (target(int(column)) + (column > 0u ? target(int(column) - 1) : 0.0));
}

// Returns the ink of the texel whose index entry is at word `entry`. runs: word at which the runs begin; place: place
// of the amount among the columns (place_of).
float texel_ink(uint entry, uint runs, float amount, float place)
{
    uint end = word(entry + 1u), above_column = uint(place);
    float below = 0.0, above = 0.0, half_way = 2.0;
    for (uint i = word(entry); i < end; i++) {
        uint run = word(runs + (i >> 1)) >> (16u * (i & 1u)), column = run & 255u;
        float ink = float(run >> 8 & 255u) / 255.0;
#ifdef SOFT
        if (ink >= 0.5) {
            half_way = half_before(column);
            break;
        }
#else
        if (column > above_column)
            break;
        above = ink;
        below = column < above_column ? ink : below;
#endif
    }
#ifdef SOFT
    return clamp(4.0 * (amount - half_way), 0.0, 1.0);
#else
    return mix(below, above, fract(place));
#endif
}

float level_ink(uint level, uint runs, float amount, float place)
{
    int size = max(int(word(1u) >> level), 1);
    uint index = word(8u + level);
    vec2 at = fract(column_place) * float(size) - 0.5, low = floor(at), part = at - low;
    float ink = 0.0;
    for (int tap = 0; tap < 4; tap++) {
        ivec2 corner = ivec2(tap & 1, tap >> 1);
        vec2 weights = mix(1.0 - part, part, vec2(corner));
        ivec2 texel = (ivec2(low) + corner + size) % size;
        float weight = weights.x * weights.y;
        if (weight > 0.0)
            ink += weight * texel_ink(index + uint(texel.y * size + texel.x), runs, amount, place);
    }
    return ink;
}

float exact_ink(float amount)
{
    float level = clamp(column_level, 0.0, float(word(2u)) - 1.0), finer = floor(level);
    float place = place_of(amount), ink = 0.0;
    uint runs = word(5u);
    for (float l = finer; l < level + 1.0; l++)
        ink += (1.0 - abs(l - level)) * level_ink(uint(l), runs, amount, place);
    return ink;
}
