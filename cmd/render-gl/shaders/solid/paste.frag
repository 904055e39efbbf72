// Last pass of the collage: strips of paper with white borders where they meet.
#include "frame/frame.glsl"

layout(binding = UNIT_TECHNIQUE + 1) uniform sampler2D strips;
layout(binding = UNIT_TECHNIQUE + 2) uniform sampler2D ranges;
layout(binding = UNIT_TECHNIQUE + 3) uniform sampler2D places; // where the paper is taken from
layout(binding = UNIT_TECHNIQUE + 4) uniform sampler2D depths;
out vec4 o_color;

void main()
{
    ivec2 here = ivec2(gl_FragCoord.xy), last = textureSize(strips, 0) - 1;
    vec2 range = texelFetch(ranges, here, 0).xy;
    if (texelFetch(strips, here, 0).a == 0.0)
        discard;
    vec4 strip = texelFetch(strips, clamp(here + ivec2(texelFetch(places, here, 0).xy), ivec2(0), last), 0);
    if (strip.a == 0.0)
        strip = texelFetch(strips, here, 0);
    o_color = vec4(range.x == range.y ? strip.rgb : vec3(max(max(paper.r, paper.g), max(paper.b, 0.9))), 1.0);
    gl_FragDepth = texelFetch(depths, here, 0).x;
}
