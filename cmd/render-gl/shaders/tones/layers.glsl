// Reads columns from the layers of an array texture, in the fragment stage. aim() must be called first.
#include "tones/targets.glsl"
#include "tones/tones.glsl"

vec3 column(float index)
{
    vec3 texel = read_columns(max(index - 1.0, 0.0)).rgb;
    return index < 0.5 ? vec3(0.0) : texel;
}

vec3 blend(float place)
{
    float below = min(floor(place), float(counts.y) - 1.0);
    return mix(column(below), column(below + 1.0), place - below);
}
