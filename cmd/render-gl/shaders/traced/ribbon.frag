// Draws a stroke over the canvas. Its opacity is the share of a sample's width that it covers.
#include "frame/frame.glsl"
#include "traced/style.glsl"

layout(location = UNIFORM_INK) uniform int ink_index;
noperspective in vec3 v_across;
noperspective in vec2 v_ends;
out vec4 o_color;

void main()
{
    float taper = clamp(min(v_ends.x, v_ends.y) / min(hand.w, 0.3 * (v_ends.x + v_ends.y)), 0.0, 1.0);
    float half_width = v_across.y * taper * (2.0 - taper);
    float covered = min(half_width, v_across.x + 0.5) - max(-half_width, v_across.x - 0.5);
    o_color = vec4(ink_index == 0 ? ink.rgb : light_ink.rgb, clamp(covered, 0.0, 1.0) * v_across.z);
}
