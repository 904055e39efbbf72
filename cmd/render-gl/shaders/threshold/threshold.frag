// Threshold textures: each texel's ink is a step function of tone (Webb et al. 2002, section 3.2).
#include "frame/amounts.glsl"
#include "frame/inks.glsl"
#include "tones/tones.glsl"

in vec2 v_texcoord;
out vec4 o_color;

#ifdef EXACT
#include "tones/exact.glsl"

// Returns the opacity, which is 1 for exact runs; exact_ink() reads their steps itself.
float read_steps()
{
    return 1.0;
}

float coverage(float amount)
{
    return exact_ink(amount);
}

vec2 modulated(vec2 asked)
{
    return asked;
}
#else
// The texel's steps: the tone of each and the ink that it adds. They are read once for both inks.
vec4 step_at[2], step_height[2];

#ifdef SOFT
// Returns the tone from which on the texel is more ink than paper.
float half_way()
{
    float sum = 0.0, at = 2.0;
    for (int i = 6; i >= 0; i--)
        sum += step_height[i / 4][i % 4];
    for (int i = 6; i >= 0; i--) {
        at = sum >= 0.5 ? step_at[i / 4][i % 4] : at;
        sum -= step_height[i / 4][i % 4];
    }
    return at;
}
#endif

// Returns the amounts of both inks where the light is multiplied by the texel's modulation.
vec2 modulated(vec2 asked)
{
    float left = step_at[1].a, range = curve.y - curve.x;
    if (counts.z == 0)
        return vec2(1.0 - (1.0 - asked.x) * left, 0.0);
    if (counts.z == 1)
        return vec2(asked.x * left, 0.0);
    float light = 0.5 - 0.5 * (asked.x - asked.y) / max(range, 1e-6); // ink_amounts() turned round
    return asked + (two_amounts(1.0 - light * left) - two_amounts(1.0 - light)); // faces may have some of both inks
}

float coverage(float tone)
{
#ifdef SOFT
    return clamp(4.0 * (tone - half_way()), 0.0, 1.0);
#else
    vec4 taken = vec4(greaterThan(vec4(tone), step_at[0]));
    vec3 taken_last = vec3(greaterThan(vec3(tone), step_at[1].rgb));
    return dot(taken, step_height[0]) + dot(taken_last, step_height[1].rgb);
#endif
}

// Reads the steps for coverage(); returns the opacity of the outline. With few bins there are two layers only.
float read_steps()
{
    if (counts.y == 2) {
        step_at[0] = read_columns(0.0);
        step_height[0] = read_columns(1.0);
        step_at[1] = vec4(1.0);
        step_height[1] = vec4(0.0);
        return 1.0;
    }
    for (int half_of = 0; half_of < 2; half_of++) {
        step_at[half_of] = read_columns(float(half_of));
        step_height[half_of] = read_columns(float(2 + half_of));
    }
    return step_height[1].a;
}
#endif

void main()
{
    aim(v_texcoord);
    base_holes();
    opacity *= read_steps();
    vec2 asked = modulated(amounts());
    float light = 0.0;
#ifdef TWO_INKS
    light = coverage(asked.y);
#endif
    o_color = vec4(ink_on_paper(vec3(coverage(asked.x)), vec3(light)), opacity);
}
