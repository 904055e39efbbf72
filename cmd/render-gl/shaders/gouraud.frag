#include "light.glsl"
#include "inks.glsl"
#include "base.glsl"

#ifdef BASE_TONE
in float v_light;
#else
in vec2 v_amounts;
#endif
out vec4 o_color;

void main()
{
#ifdef BASE_TONE
    vec2 v_amounts = ink_amounts(v_light * base_light());
#endif
    base_holes();
    o_color = vec4(ink_on_paper(v_amounts.xxx, v_amounts.yyy), 1.0);
}
