// How strokes are drawn: struct traced_block of technique/traced/traced.h, where the members are explained.
layout(std140, binding = BLOCK_TECHNIQUE) uniform Style {
    vec4 pen;  // width in pixels, thin; samples along a pixel's side; tangent of the greatest turn
    vec4 hand; // vary, pressure, wobble in pixels, length of tapered ends in pixels
    vec4 matter; // darkness of a stroke, grain
    vec4 marks; // length and gap in pixels, scatter; 1: they are dots
    vec4 tones[8][9]; // per family: tone at ink 0, 1/32 .. 1
};

float tone_of(int family, float ink)
{
    float at = clamp(ink, 0.0, 1.0) * 32.0;
    int low = min(int(at), 31), high = low + 1;
    return mix(tones[family][low >> 2][low & 3], tones[family][high >> 2][high & 3], at - float(low));
}
