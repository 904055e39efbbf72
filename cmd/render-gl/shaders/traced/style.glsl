// How strokes are drawn: struct traced_block of technique/traced/traced.h, where the members are explained.
layout(std140, binding = BLOCK_TECHNIQUE) uniform Style {
    vec4 pen;  // width in pixels, thin; samples along a pixel's side; tangent of the greatest turn
    vec4 hand; // vary, pressure, wobble in pixels, length of tapered ends in pixels
    vec4 matter; // darkness of a stroke, grain, grazing
    vec4 marks; // length and gap in pixels, scatter; 1: they are dots
    vec4 tones[8][9]; // per family: tone at ink 0, 1/32 .. 1
    vec4 narrow_tones[8][9]; // the same on narrow faces, in the order in which families join
    vec4 zigzag; // amplitude and wave in pixels; waves along a whole stroke, 0: as many as its length has; stretch
    uvec4 look; // numbers of values of both profiles; of colours; 1: they are mixed
    vec4 profiles[2][2]; // of width, of pressure
    vec4 colors[16]; // of strokes
};

// Returns a profile at a place along the stroke, 0 .. 1. which: 0: width, 1: pressure
float look_profile(int which, float at)
{
    int count = int(look[which]);
    if (count == 0)
        return 1.0;
    float place = clamp(at, 0.0, 1.0) * float(count - 1);
    int low = min(int(place), count - 2), high = low + 1;
    return mix(profiles[which][low >> 2][low & 3], profiles[which][high >> 2][high & 3], place - float(low));
}

// Returns the tone of a family. crossing: the one that crosses a narrow face and is the first there; narrow: how much
// the face is one, 0 .. 1
float tone_of(int family, float ink, int crossing, float narrow)
{
    float at = clamp(ink, 0.0, 1.0) * 32.0;
    int low = min(int(at), 31), high = low + 1;
    float tone = mix(tones[family][low >> 2][low & 3], tones[family][high >> 2][high & 3], at - float(low));
    if (narrow <= 0.0)
        return tone;
    int order = family == crossing ? 0 : family < crossing ? family + 1 : family;
    float alone =
        mix(narrow_tones[order][low >> 2][low & 3], narrow_tones[order][high >> 2][high & 3], at - float(low));
    return mix(tone, alone, narrow);
}
