// Draws the strokes of all layers of seed points.
#include "frame/amounts.glsl"
#include "frame/inks.glsl"
#include "rptam/layers.glsl"

out vec4 o_color;

void main()
{
    base_holes();
    vec2 asked = amounts();
    mat2 pixels = pixels_along_both();
#ifdef TWO_INKS
    float light = ink_of(pixels, asked.y);
#else
    float light = 0.0;
#endif
    o_color = vec4(ink_on_paper(vec3(ink_of(pixels, asked.x)), vec3(light)), opacity);
}
