// Draws each patch in its own tone, shaded by the light.
#include "frame/frame.glsl"
#include "frame/inks.glsl"
#include "frame/base.glsl"

in float v_lightness;
flat in float v_tone;
out vec4 o_color;

void main()
{
    base_holes();
    float lightness = (1.0 - v_tone) * (0.5 + 0.5 * v_lightness);
    o_color = vec4(ink_on_paper(vec3(1.0 - lightness), vec3(0.0)), opacity);
}
