// Strokes of patches go on where the patch ends, but the surface does not: up to their own ends, by the curve. A part
// of a stroke whose middle is on the surface, but beyond the patch, belongs to no patch and is not drawn.
#include "strokes/doubled.glsl"

layout(binding = UNIT_SOURCE) uniform sampler2D owners; // owner.frag

const float STEP_PX = 3.0; // at most, between two looks at the surface
const int STEPS_MOST = 64;
const float ROUGH = 0.0005;    // greatest change of the slope of depth per step, as a share of depth
const float SHARE_LEAST = 0.4; // least share of a stroke on its patch, if it goes on at both ends
const float ALIKE = 0.3;       // least cosine of twice the angle between directions of patches
const float THIN = 0.3;        // where a stroke is thinner than this, in mean widths, the tone ends it

bool is_lapped(uint first)
{
    return (sorted[first].y & FRAGMENT_LAPPED) != 0u;
}

// Returns what owner.frag has written at a place where patches are on top, or else zeros.
vec4 owner_at(vec2 place)
{
    ivec2 at = ivec2(floor(place));
    if (any(lessThan(at, ivec2(0))) || any(greaterThanEqual(at, textureSize(owners, 0))))
        return vec4(0.0);
    vec4 found = texelFetch(owners, at, 0);
    return found.x > 1.5 ? found : vec4(0.0);
}

// Returns twice the angle from the direction of u to that of the curve, as a direction.
vec2 turn_of(vec4 owner, vec2 way)
{
    vec2 curve = doubled(way);
    return vec2(dot(owner.zw, curve), owner.z * curve.y - owner.w * curve.x);
}

// Follows the curve from u, one of its ends, to a u further on. Returns whether it stays on the surface, where depth
// does not jump, and the patches there have the direction of its own.
bool follow(Cubic cubic, float u, float to)
{
    int steps = clamp(int(ceil(distance(place_on(cubic, u), place_on(cubic, to)) / STEP_PX)), 1, STEPS_MOST);
    float part = (to - u) / float(steps);
    vec2 place = place_on(cubic, u), before = place_on(cubic, u - part);
    vec4 owner = owner_at(place);
    vec2 turn = turn_of(owner_at(place_on(cubic, 0.0)), place_on(cubic, 0.01) - place_on(cubic, -0.01));
    float slope = owner.y - owner_at(before).y;
    for (int k = 0; k < steps; k++) {
        u += part;
        vec2 further = place_on(cubic, u);
        vec4 next = owner_at(further);
        float change = next.y - owner.y;
        if (!(next.y > 0.0) || abs(change - slope) > abs(slope) + ROUGH * owner.y ||
            dot(turn_of(next, further - place), turn) < ALIKE)
            return false;
        slope = change;
        owner = next;
        place = further;
    }
    return true;
}

// Returns whether a stroke is cut off at both ends so that only a small share of it is on the patch, which is narrow
// there: parts of it fill the patch.
bool is_part(vec2 own)
{
    return own.x < -1.0 && own.y > 1.0 && 2.0 < SHARE_LEAST * (own.y - own.x);
}

// Returns u of both ends of a stroke whose middle is on the patch: its own ends where the surface goes on that far.
// thick: widths at the ends, in mean widths
vec2 follow_both(Cubic cubic, vec2 own, vec2 thick)
{
    vec2 ends = vec2(-1.0, 1.0);
    if (abs(u_of(cubic, 0.5)) > 1.0 || is_part(own))
        return ends;
    if (own.x < -1.0 && thick.x > THIN && follow(cubic, -1.0, own.x))
        ends.x = own.x;
    if (own.y > 1.0 && thick.y > THIN && follow(cubic, 1.0, own.y))
        ends.y = own.y;
    return ends;
}

// Returns whether the middle is beyond the patch, though on the surface.
bool has_middle_elsewhere(Cubic cubic, vec2 own, vec2 thick)
{
    float middle = u_of(cubic, 0.5);
    return abs(middle) > 1.0 && !is_part(own) && (middle < 0.0 ? thick.x : thick.y) > THIN &&
           follow(cubic, sign(middle), middle);
}
