// Tests whether surfaces hide a sample of a line, and whether a halo covers it. The sample is visible if any of the
// depths around it is not nearer: the surface of a silhouette may be nearer on one side of it, but never on both.
#include "halo/halo.glsl"

layout(binding = UNIT_TONES) uniform sampler2D depths;
layout(binding = UNIT_SOURCE) uniform sampler2D points; // x, y in pixels; depth limit; angle of the line
layout(location = UNIFORM_A) uniform float samples_per_pixel;

out uint o_seen; // bits of enum hatch_line_seen: 1: visible; 2: a halo covers a part of it; 4: more than half of it

const float REACH_PX = 1.25;

void main()
{
    vec4 point = texelFetch(points, ivec2(gl_FragCoord.xy), 0);
    ivec2 last = textureSize(depths, 0) - 1;
    float least = 1.0;
    for (int y = -1; y <= 1; y++)
        for (int x = -1; x <= 1; x++) {
            vec2 at = (point.xy + REACH_PX * vec2(x, y)) * samples_per_pixel;
            least = min(least, texelFetch(depths, clamp(ivec2(floor(at)), ivec2(0), last), 0).r);
        }
    o_seen = uint(least <= point.z);
#ifdef HALOES
    float share = halo_over_line(point.xy, point.z, vec2(cos(point.w), sin(point.w)));
    o_seen += share > 0.0 ? 2u : 0u;
    o_seen += share > 0.5 ? 4u : 0u;
#endif
}
