// Draws paper where the halo of a nearer edge lies.
#include "halo/halo.glsl"

layout(location = UNIFORM_A) uniform vec3 paper;

flat in float v_nearest;
out vec4 o_color;

void main()
{
    ivec2 at = ivec2(gl_FragCoord.xy);
    float depth = depth_of(at);
    bool behind = depth > 0.0 && jump_between(v_nearest, depth) > halo_depth.z;
    if (!behind)
        discard;
    float share = halo_over(gl_FragCoord.xy, depth_around(at, behind), slope_of(at), vec2(0.0));
    if (share <= 0.0)
        discard;
    o_color = vec4(paper, share);
}
