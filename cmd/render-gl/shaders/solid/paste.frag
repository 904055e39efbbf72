// Last pass of the collage: strips of paper with white borders where they meet.
#include "frame/frame.glsl"

layout(binding = UNIT_TECHNIQUE + 1) uniform sampler2D strips;
layout(binding = UNIT_TECHNIQUE + 2) uniform sampler2D ranges;
layout(binding = UNIT_TECHNIQUE + 4) uniform sampler2D depths;
out vec4 o_color;

void main()
{
    ivec2 here = ivec2(gl_FragCoord.xy);
    vec4 strip = texelFetch(strips, here, 0);
    vec2 range = texelFetch(ranges, here, 0).xy;
    if (strip.a == 0.0)
        discard;
    o_color = vec4(range.x == range.y ? strip.rgb : vec3(max(max(paper.r, paper.g), max(paper.b, 0.9))), 1.0);
    gl_FragDepth = texelFetch(depths, here, 0).x;
}
