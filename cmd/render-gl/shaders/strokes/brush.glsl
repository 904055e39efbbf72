// The image of a brush, and its grain, which has a texel per pixel.
layout(binding = UNIT_TECHNIQUE + 1) uniform sampler2D brush_image;
layout(binding = UNIT_TECHNIQUE + 2) uniform sampler2D brush_grain;
layout(location = UNIFORM_BRUSH) uniform float brush_length; // of the whole stroke, in pixels

// Returns alpha at a place in a stroke. t: along it; across, half_width: in pixels
float brush_alpha(uint stroke, float t, float across, float half_width)
{
    vec2 grain = vec2(t * brush_length, across) + vec2(mix_bits(stroke) & 63u, mix_bits(stroke + 1u) & 63u);
    float v = clamp(0.5 + 0.5 * across / max(half_width, 1e-3), 0.0, 1.0);
    return textureLod(brush_image, vec2(t, v), 0.0).r * textureLod(brush_grain, grain / 64.0, 0.0).r;
}
