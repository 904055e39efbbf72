// Tests whether surfaces hide a sample of a line, and whether a halo covers it. A sample is hidden if all depths around
// it are nearer: the surface of a silhouette may be nearer on one side of it, but never on both. A sample of a
// silhouette also needs a step in depth beyond it.
#include "halo/halo.glsl"
#ifdef BRUSH
#include "frame/light.glsl"
#endif

layout(binding = UNIT_TONES) uniform sampler2D depths;
layout(binding = UNIT_SOURCE) uniform sampler2D points; // two texels: x, y in pixels; depth limit; angle of the line;
                                                        // direction away from a silhouette; `behind`; depth
layout(location = UNIFORM_LINE_SAMPLES) uniform float samples_per_pixel;
#ifdef BRUSH
// From pixels to the unit scene. place[0]: the eye; distance of the near plane, times 1 + shift of depth. place[1],
// place[2]: change of the direction, at distance 1, or of the place in orthographic views, per pixel; place[1].w: shift
// of depth (view/view.h). place[3]: the direction, or the place
// beside the eye, of the corner; distance of the far plane.
layout(location = UNIFORM_LINE_PLACE) uniform vec4 place[4];
layout(location = UNIFORM_LINE_BRUSH) uniform vec2 shares; // depth and tone of struct hatch_line_brush
#endif

out uint o_seen; // bits of enum hatch_line_seen: 1: visible; 2: a halo covers a part of it; 4: more than half of it;
                 // 8: visible but for the step; from 16 on: the weight of the line

const float REACH_PX = 1.25;
const float CLIFF = 8.0; // least steps in depth, over REACH_PX

float depth_at(vec2 at_px)
{
    ivec2 last = textureSize(depths, 0) - 1;
    return texelFetch(depths, clamp(ivec2(floor(at_px * samples_per_pixel)), ivec2(0), last), 0).r;
}

// Returns whether the surface beyond a silhouette lies deeper than `behind` at the silhouette, if continued up to it
// with its own slope: one that merely recedes does not. A larger slope than CLIFF is another step.
bool is_step(vec2 at, vec2 away, float behind, float depth)
{
    float first = depth_at(at + REACH_PX * away), second = depth_at(at + 2.0 * REACH_PX * away);
    float slope = first - second > CLIFF * (depth - behind) ? 0.0 : max(first - second, 0.0);
    return first + slope < behind;
}

#ifdef BRUSH
const float DEEP = 0.12; // step in depth at which a line has half of the weight that steps give, in the unit scene

float distance_of(float depth)
{
    return eye.w > 0.0 ? place[0].w / max(depth + place[1].w, 1e-6) : place[3].w - (place[3].w - place[0].w) * depth;
}

// Returns the weight, 0 .. 15, of a line: greater where the surface behind it is deeper, and in the dark.
// away: out of a silhouette, else 0; depth: of the line; deepest: of what surrounds it
uint weight_of(vec2 at, vec2 away, float depth, float deepest)
{
    float here = distance_of(depth), step = max(distance_of(deepest) - here, 0.0);
    vec3 way = place[1].xyz * at.x + place[2].xyz * at.y + place[3].xyz;
    vec3 point = place[0].xyz + (eye.w > 0.0 ? here * way : way - here * eye.xyz);
    vec3 normal = away.x * normalize(place[1].xyz) + away.y * normalize(place[2].xyz);
    if (away == vec2(0.0))
        normal = normalize(eye.xyz - eye.w * point);
    float tone = ink_amounts(light_at(point, normal, normal)).x;
    float weight = (1.0 + shares.x * (step / (step + DEEP) - 0.5)) * (1.0 + shares.y * (tone - 0.5));
    return uint(clamp(7.5 * (weight - 0.25) + 0.5, 0.0, 15.0));
}
#endif

void main()
{
    ivec2 at = ivec2(2 * int(gl_FragCoord.x), int(gl_FragCoord.y));
    vec4 point = texelFetch(points, at, 0), beyond = texelFetch(points, at + ivec2(1, 0), 0);
    float least = 1.0;
    for (int y = -1; y <= 1; y++)
        for (int x = -1; x <= 1; x++)
            least = min(least, depth_at(point.xy + REACH_PX * vec2(x, y)));
    bool ends = beyond.xy == vec2(0.0) || is_step(point.xy, beyond.xy, beyond.z, beyond.w);
    o_seen = least > point.z ? 0u : ends ? 1u : 8u;
#ifdef HALOES
    float share = halo_over_line(point.xy, point.z, vec2(cos(point.w), sin(point.w)));
    o_seen += share > 0.0 ? 2u : 0u;
    o_seen += share > 0.5 ? 4u : 0u;
#endif
#ifdef BRUSH
    o_seen += 16u * weight_of(point.xy, beyond.xy, point.z, least);
#endif
}
