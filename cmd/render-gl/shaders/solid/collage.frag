// First pass of the collage (section 4.3): bands of tone, each cut from the paper of a texture.
#include "frame/amounts.glsl"
#include "solid/zoom.glsl"

layout(location = 0) out vec4 o_paper; // colour of the strip
layout(location = 1) out vec4 o_strip; // number of the strip, over 0; width of its border relative to the usual

void main()
{
    base_holes();
    vec2 asked = amounts();
    Cycle cycle = cycle_here();
    float tone = asked.y > 0.0 ? 0.5 - 0.5 * asked.y : counts.z == 2 ? 0.5 + 0.5 * asked.x : asked.x;
    float wobble = variation(0, cycle, vec3(0.5, 0.25, 0.75), 1.0, 0.0);
    tone += marks.y * wobble * length(vec2(dFdx(tone), dFdy(tone)));
    float band = clamp(floor(tone * edges.x), 0.0, edges.x - 1.0);
    int solid = min(int(band * float(SOLIDS) / edges.x), SOLIDS - 1);
    vec3 texture = texture_color(solid, cycle) / max(colors[solid].offset.w, 0.02);
    vec2 amount = vec2((band + 0.5) / edges.x, 0.0);
    if (counts.z == 2)
        amount = vec2(max(2.0 * amount.x - 1.0, 0.0), max(1.0 - 2.0 * amount.x, 0.0));
#if CHANNELS == 3
    vec3 dark = 1.0 - mix(vec3(1.0), texture, marks.x) * (1.0 - amount.x); // papers in their own colours
#else
    vec3 dark = amount.x + marks.x * (0.1 + min(amount.x, 1.0 - amount.x)) * (1.0 - texture);
#endif
    vec3 light = amount.y + marks.x * min(amount.y, 1.0 - amount.y) * (texture - 1.0);
    o_paper = vec4(base_color(0.0) * own_ink_on_paper(clamp(dark, 0.0, 1.0), clamp(light, 0.0, 1.0)), 1.0);
    o_strip = vec4(float(item % 32u) * 16.0 + band + 1.0, 1.0 + 0.4 * wobble, 0.0, 0.0);
}
