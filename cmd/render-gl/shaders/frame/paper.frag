// Draws bare paper, which hides the surfaces behind it.
#include "frame/frame.glsl"

out vec4 o_color;

void main()
{
    o_color = vec4(paper.rgb, 0.0);
}
