// Columns as layers, read in the fragment stage.
#include "array.glsl"
#include "columns.glsl"

vec3 column(float index, vec2 texcoord)
{
    vec3 texel = read_columns(texcoord, max(index - 1.0, 0.0));
    return index < 0.5 ? vec3(0.0) : texel;
}

vec3 blend(float place, vec2 texcoord)
{
    float below = min(floor(place), float(counts.y) - 1.0);
    return mix(column(below, texcoord), column(below + 1.0, texcoord), place - below);
}
