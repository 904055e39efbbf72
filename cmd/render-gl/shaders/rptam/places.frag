// For tests: writes the place of a fragment in the first layer's pattern. u and v are taken modulo 4 tiles, divided by
// 4, and written as two digits of base 1024 each, which half floats can hold. Discards fragments without a nesting
// depth.
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
