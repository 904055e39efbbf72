// Two texture reads and two dot products an ink. Texels are ink: what no column covers stays paper.
#include "light.glsl"
#include "ramp.glsl"
#include "inks.glsl"
#include "columns.glsl"
#include "base.glsl"

in vec2 v_texcoord;
#ifdef BASE_TONE
in float v_light;
#else
in vec3 v_dark_first, v_dark_second;
#ifdef TWO_INKS
in vec3 v_light_first, v_light_second;
#endif
#endif
out vec4 o_color;

float finish(float coverage)
{
#ifdef THRESHOLD
    return 1.0 - clamp(8.0 * (1.0 - coverage) - 3.5, 0.0, 1.0);
#else
    return coverage;
#endif
}

void main()
{
    aim(v_texcoord);
    vec3 first = read_columns(0.0), second = read_columns(1.0);
#ifdef BASE_TONE
    vec3 v_dark_first, v_dark_second, v_light_first, v_light_second;
    vec2 amounts = ink_amounts(v_light * base_light());
    column_weights(amounts.x, v_dark_first, v_dark_second);
    column_weights(amounts.y, v_light_first, v_light_second);
#endif
    base_holes();
    float dark = finish(dot(first, v_dark_first) + dot(second, v_dark_second));
    float light = 0.0;
#ifdef TWO_INKS
    light = finish(dot(first, v_light_first) + dot(second, v_light_second));
#endif
    o_color = vec4(ink_on_paper(vec3(dark), vec3(light)), 1.0);
}
