// Computes the share of a pixel that a line covers, from the distance between the pixel's centre and the line's middle.
// The share falls off over the extent of the pixel's square across the line. A line narrower than a pixel is drawn one
// pixel wide and paler.
#include "halo/halo.glsl"

layout(location = UNIFORM_B) uniform float width_px;

flat in vec4 v_ends;
flat in vec3 v_depth;
flat in vec4 v_brush;
out float o_coverage;

void main()
{
    vec2 along = v_ends.zw - v_ends.xy, from = gl_FragCoord.xy - v_ends.xy;
    float share = clamp(dot(from, along) / max(dot(along, along), 1e-12), 0.0, 1.0);
    vec2 away = from - share * along;
    float distance_px = length(away);
    float ramp = distance_px > 1e-3 ? (abs(away.x) + abs(away.y)) / distance_px : 1.0;
    float wide_px = width_px * mix(v_brush.x, v_brush.y, share), inside = 0.5 * max(wide_px, 1.0) - distance_px;
    o_coverage = clamp(inside / ramp + 0.5, 0.0, 1.0) * min(wide_px, 1.0) * mix(v_brush.z, v_brush.w, share);
#ifdef HALOES
    int asked = o_coverage > 0.0 && v_depth.z > 0.0 ? 1 : 0;
    for (int i = 0; i < asked; i++) // instead of an `if`, which software renderers would execute for all pixels
        o_coverage *= 1.0 - halo_over_line(v_ends.xy + share * along, mix(v_depth.x, v_depth.y, share), along);
#endif
}
