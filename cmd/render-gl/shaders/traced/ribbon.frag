// Draws a stroke over the canvas. Its opacity is the share of a sample's width that it covers.
#include "frame/frame.glsl"

layout(location = UNIFORM_INK) uniform int ink_index;
noperspective in vec3 v_across;
out vec4 o_color;

void main()
{
    float covered = min(v_across.y, v_across.x + 0.5) - max(-v_across.y, v_across.x - 0.5);
    o_color = vec4(ink_index == 0 ? ink.rgb : light_ink.rgb, clamp(covered, 0.0, 1.0) * v_across.z);
}
