// Draws lines over the picture by their coverage.
#include "traced/noise.glsl"

layout(binding = UNIT_TONES) uniform sampler2D coverage;
layout(location = UNIFORM_A) uniform vec3 color;
layout(location = UNIFORM_B) uniform vec2 ink; // darkness; share of it that the grain of the paper leaves out
layout(location = UNIFORM_C) uniform vec2 corner; // of the tile in the picture, in pixels: the paper's grain is there
out vec4 o_color;

void main()
{
    float share = texelFetch(coverage, ivec2(gl_FragCoord.xy), 0).r;
    if (share <= 0.0)
        discard;
    share *= ink.x;
    if (ink.y > 0.0)
        share *= 1.0 - ink.y * paper_grain(gl_FragCoord.xy + corner);
    o_color = vec4(color, share);
}
