// Draws a mark. It is the darker, the greater the confidence of its direction.
#include "frame/frame.glsl"
#include "frame/inks.glsl"

flat in float v_confidence;
out vec4 o_color;

void main()
{
    o_color = vec4(ink_on_paper(vec3(0.5 + 0.5 * clamp(v_confidence, 0.0, 1.0)), vec3(0.0)), 1.0);
}
