// For tests: writes the place of a fragment in the solid texture, in periods at the beginning of its cycle: x, and the
// sum of y and z. Both are taken modulo 4, divided by 4, and written as two digits of base 1024, which half floats can
// hold.
#include "frame/amounts.glsl"
#include "frame/inks.glsl"
#include "solid/zoom.glsl"

out vec4 o_places;

vec2 digits(float place)
{
    float first = fract(0.25 * place) * 1024.0;
    return vec2(floor(first) / 1024.0, floor(fract(first) * 1024.0) / 1024.0);
}

void main()
{
    base_holes();
    vec3 place = cycle_here().place;
    o_places = vec4(digits(place.x), digits(place.y + place.z));
}
