// Draws bare paper, on which strokes are drawn.
#include "frame/frame.glsl"
#include "frame/base.glsl"

out vec4 o_color;

void main()
{
    base_holes();
    o_color = vec4(paper.rgb, 1.0);
}
