// Draws the tone without strokes.
#include "frame/amounts.glsl"
#include "frame/inks.glsl"

out vec4 o_color;

void main()
{
    vec2 asked = amounts();
    base_holes();
    o_color = vec4(ink_on_paper(asked.xxx, asked.yyy), 1.0);
}
