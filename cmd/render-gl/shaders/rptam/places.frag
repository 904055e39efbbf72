// Where fragments lie among the first layer's seeds: u and v over 4 less whole numbers, as two digits of 1024
// each, which half floats hold. Nothing where no depth is right.
#include "frame/light.glsl"
#include "frame/base.glsl"
#include "rptam/seeds.glsl"
#include "rptam/place.glsl"

out vec4 o_places;

vec2 digits(float place)
{
    float first = fract(0.25 * place) * 1024.0;
    return vec2(floor(first) / 1024.0, floor(fract(first) * 1024.0) / 1024.0);
}

void main()
{
    base_holes();
    if (opacity < 0.5)
        discard;
    float depth = log2(sqrt(layers[0].turn.z) / width_across(pixels_along_both(), layers[0].turn.xy));
    if (!(abs(depth) < 60.0))
        discard;
    vec2 at = place_at(floor(depth));
    o_places = vec4(digits(at.x), digits(at.y));
}
