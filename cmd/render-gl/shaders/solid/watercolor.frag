// Last pass of the watercolour: pigment on paper (Bousseau et al. 2006, section 3). A pigment density d turns the
// colour C of a wash into C - (C - C^2) (d - 1).
#include "solid/image.glsl"

out vec4 o_color;

void main()
{
    ivec2 here = ivec2(gl_FragCoord.xy);
    vec4 wet = texelFetch(wash, here, 0), texel = texelFetch(grain, here, 0);
    float height = paper_height(gl_FragCoord.xy, 0.5), rank = 0.5 + 0.5 * height;
    if (wet.z > 0.0 && texel != vec4(0.0)) {
        rank = texel.x;
        height = 2.0 * rank - 1.0;
    }
    vec3 color = ink_on_paper(wet.xxx, wet.yyy);
    float edge = max(wet.w - texelFetch(blurred, here, 0).x, 0.0);
    float density = 1.0 + marks.x * (0.6 * height + 0.5 * texel.y) + 5.0 * marks.w * edge;
    vec3 base = clamp(color, 0.004, 0.97);
    color = wet.z > 0.0 ? clamp(color - (base - base * base) * (density - 1.0), 0.0, 1.0) : color;
    float bare = smoothstep(0.0, 0.12, rank - 1.0 + marks.z * (1.0 - wet.x) * wet.z);
    color = mix(color, paper.rgb, bare);
    o_color = vec4(color * (1.0 - 0.25 * edges.z * max(-height, 0.0)), 1.0);
    gl_FragDepth = max(texelFetch(depths, here, 0).x, 1e-30);
}
