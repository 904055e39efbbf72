// Blends up to six columns with one or two texture reads, and a dot product per read and ink. Texels hold ink, so that
// paper remains where no column has any.
#include "tones/ramp.glsl"
#include "frame/amounts.glsl"
#include "frame/inks.glsl"
#include "tones/tones.glsl"

in vec2 v_texcoord;
#ifdef WEIGHTS_AT_VERTICES
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

// Returns the coverage by both inks. The first layer holds columns 1 to 4, the second 3 to 6, so that two neighbouring
// columns share a layer and nearly all samples read only one. A loop replaces an `if`, because software renderers
// execute both branches of an `if`, but leave a loop as soon as all samples have left it.
vec2 blend(vec3 dark_first, vec3 dark_second, vec3 light_first, vec3 light_second)
{
    vec2 pale = dark_first.xy + light_first.xy, deep = dark_second.yz + light_second.yz;
    float last = deep.x + deep.y > 0.0 ? 1.0 : 0.0;
    float layer = pale.x + pale.y > 0.0 ? 0.0 : last;
    vec4 dark = layer == 0.0 ? vec4(dark_first, dark_second.x) : vec4(dark_first.z, dark_second);
    vec4 light = layer == 0.0 ? vec4(light_first, light_second.x) : vec4(light_first.z, light_second);
    vec2 sum = vec2(0.0);
    for (;;) {
        vec4 texel = read_columns(layer);
        sum += vec2(dot(texel, dark), dot(texel, light));
        if (layer == last)
            break;
        layer = last;
        dark = vec4(0.0, 0.0, dark_second.yz);
        light = vec4(0.0, 0.0, light_second.yz);
    }
    return sum;
}

void main()
{
    aim(v_texcoord);
    base_holes();
#ifndef WEIGHTS_AT_VERTICES
    vec3 v_dark_first, v_dark_second, v_light_first, v_light_second;
    vec2 asked = amounts();
    column_weights(asked.x, v_dark_first, v_dark_second);
    column_weights(asked.y, v_light_first, v_light_second);
#endif
#ifdef TWO_INKS
    vec2 ink = blend(v_dark_first, v_dark_second, v_light_first, v_light_second);
    o_color = vec4(ink_on_paper(vec3(finish(ink.x)), vec3(finish(ink.y))), opacity);
#else
    vec2 ink = blend(v_dark_first, v_dark_second, vec3(0.0), vec3(0.0));
    o_color = vec4(ink_on_paper(vec3(finish(ink.x)), vec3(0.0)), opacity);
#endif
}
