// Blends over the face the three columns that are nearest to the tones of its vertices (tam-gouraud).
#include "tones/layers.glsl"
#include "frame/inks.glsl"
#include "frame/base.glsl"

in vec2 v_texcoord;
in vec3 v_share;
flat in vec3 v_dark_place, v_light_place;
out vec4 o_color;

vec3 coverage(vec3 places)
{
    vec3 sum = vec3(0.0);
    for (int i = 0; i < 3; i++)
        sum += v_share[i] * column(round(places[i]));
    return sum;
}

void main()
{
    aim(v_texcoord);
    base_holes();
    vec3 light = vec3(0.0);
#ifdef TWO_INKS
    light = coverage(v_light_place);
#endif
    o_color = vec4(ink_on_paper(coverage(v_dark_place), light), opacity);
}
