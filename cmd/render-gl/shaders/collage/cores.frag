// Marks the cores of strips: pixels so far from the edge that a strip with borders shows its paper there.
#include "collage/strips.glsl"

layout(binding = UNIT_SOURCE) uniform sampler2D away;
layout(location = UNIFORM_B) uniform float radius; // of the disk that fits into a wide strip, in pixels
out vec4 o_core; // as collage/nearest.frag has it

void main()
{
    vec2 own = texelFetch(away, ivec2(gl_FragCoord.xy), 0).xy;
    o_core = vec4(own.x, 0.0, 0.0, own.x == 0.0 ? 0.0 : own.y >= radius ? 2.0 : own.y >= 0.5 * radius ? 1.0 : 0.0);
}
