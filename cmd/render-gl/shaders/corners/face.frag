// Draws a face with the nearest column (tam-flat, which defines NEAREST) or with a blend of two columns (tam-face).
#include "tones/layers.glsl"
#include "frame/inks.glsl"
#include "frame/base.glsl"

in vec2 v_texcoord;
flat in vec2 v_place;
out vec4 o_color;

vec3 coverage(float where)
{
#ifdef NEAREST
    return column(round(where));
#else
    return blend(where);
#endif
}

void main()
{
    aim(v_texcoord);
    base_holes();
    vec3 light = vec3(0.0);
#ifdef TWO_INKS
    light = coverage(v_place.y);
#endif
    o_color = vec4(ink_on_paper(coverage(v_place.x), light), opacity);
}
