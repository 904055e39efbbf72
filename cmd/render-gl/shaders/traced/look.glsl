// The look of strokes along their line: libhatch/curve/stroke_look.h, where it is explained.
#include "traced/style.glsl"
#include "traced/noise.glsl"

// Returns a triangle wave of length 1, from 0 upwards, and its slope.
vec2 triangle(float at)
{
    float from = fract(at - 0.25) - 0.5;
    return vec2(4.0 * abs(from) - 1.0, from < 0.0 ? -4.0 : 4.0);
}

// Returns how far a zigzag lies beside the stroke's line, in amplitudes, and its slope per unit of `at`.
vec2 zigzag_beside(float at, float level)
{
    float low = floor(level), waves = exp2(low), part = clamp(2.0 * (level - low) - 0.5, 0.0, 1.0);
    vec2 coarse = triangle(at * waves), fine = triangle(2.0 * at * waves);
    return mix(coarse, fine * vec2(1.0, 2.0), part) * vec2(1.0, waves);
}

// Returns the colour of a stroke, which is that of the ink if the style has none.
vec3 stroke_color(uint number, vec3 ink_color)
{
    uint count = look.z, draw = mix_bits(number ^ 0x3c6ef372u) >> 8;
    if (count == 0u)
        return ink_color;
    if (look.w == 0u)
        return colors[draw * count >> 24].rgb;
    float place = float(draw) / 16777216.0 * float(count - 1u);
    uint low = uint(place);
    return mix(colors[low].rgb, colors[low + 1u].rgb, place - float(low));
}
