// First pass of the collage (section 4.3): bands of tone, each of which is a strip of paper.
#include "frame/amounts.glsl"
#include "solid/zoom.glsl"
#include "collage/strips.glsl"

out vec2 o_strip; // number of the strip, over 0; width of its border relative to the usual

void main()
{
    base_holes();
    vec2 asked = amounts();
    float tone = asked.y > 0.0 ? 0.5 - 0.5 * asked.y : counts.z == 2 ? 0.5 + 0.5 * asked.x : asked.x;
    float wobble = variation(0, cycle_here(), vec3(0.5, 0.25, 0.75), 1.0, 0.0);
    tone += marks.y * wobble * length(vec2(dFdx(tone), dFdy(tone)));
    o_strip = vec2(strip_number(int(item), int(clamp(tone * edges.x, 0.0, edges.x - 1.0))), 1.0 + 0.4 * wobble);
}
