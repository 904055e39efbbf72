// Fits a cubic to the fragments of each stroke, and extrudes it to a ribbon: RIBBON_POINTS points for
// traced/ribbon.vert. A stroke is as wide as its fragments say: the area that they cover, divided by its length.
#include "frame/frame.glsl"
#include "traced/style.glsl"
#include "traced/noise.glsl"
#include "strokes/fragments.glsl"
#include "strokes/cubic.glsl"
#include "strokes/patches.glsl"

layout(local_size_x = 32) in;
struct Slot {
    uint low, high, count, first, joined; // bits 4, 8: the stroke goes on before the start, after the end
};
layout(std430, binding = STORAGE_SLOTS) readonly buffer Slots { Slot slots[]; }; // without free ones
layout(std430, binding = STORAGE_RIBBON) writeonly buffer Ribbon { vec4 ribbon[]; };
layout(std430, binding = STORAGE_MISSED) writeonly buffer Missed { float missed[]; }; // share of the weight
layout(location = UNIFORM_COUNT) uniform uint count;
layout(location = UNIFORM_PROFILE) uniform float profile[BRUSH_PROFILE]; // mean ink along a stroke
layout(location = UNIFORM_THINNEST) uniform float thinnest; // least mean width of strokes that are drawn whole
layout(location = UNIFORM_OVERDRAW) uniform float overdraw; // pixels by which strokes go on where they are cut off

const float SHORTEST = 0.3; // least share of its length that a thin stroke keeps
const float WIDEST = 1.5; // greatest width, in widths of the pen
const float TURNS = 4.0;  // waves of the noise along a whole stroke
const float REACH = 1.5;  // distance of a stroke's fragments from its curve, in widths of the pen
const float SHORTEST_PX = 1.0;
const float CUT = 0.04; // share of t by which a stroke that is cut off falls short of its own end
const int LAST = RIBBON_POINTS - 1;

struct Path {
    vec2 places[RIBBON_POINTS];
    float lengths[RIBBON_POINTS]; // from the first
};

void measure(Cubic cubic, float from, float to, out Path path)
{
    for (int k = 0; k <= LAST; k++) {
        path.places[k] = place_on(cubic, mix(from, to, float(k) / float(LAST)));
        path.lengths[k] = k == 0 ? 0.0 : path.lengths[k - 1] + distance(path.places[k], path.places[k - 1]);
    }
}

// Computes the width of the visible part at evenly spaced u: the area of the fragments around there by the length.
// Fragments that the curve does not reach have no part in it; returns their share of the weight.
float find_widths(Slot slot, Cubic cubic, Path path, out float widths[RIBBON_POINTS])
{
    uint far = 0u, all = 0u, areas[RIBBON_POINTS]; // integers, whose sums do not depend on the order of the fragments
    for (int k = 0; k <= LAST; k++)
        areas[k] = 0u;
    for (uint i = slot.first; i < slot.first + slot.count; i++) {
        float u = u_of(cubic, t_of(sorted[i])), at = clamp(0.5 + 0.5 * u, 0.0, 1.0) * float(LAST);
        int low = min(int(at), LAST - 1);
        uint share = uint((at - float(low)) * 16.0 + 0.5), weight = sorted[i].y >> 24;
        all += weight;
        if (distance(place_on(cubic, u), pixel_of(sorted[i])) > REACH * pen.x + 1.0) {
            far += weight;
            continue;
        }
        areas[low] += weight * (16u - share);
        areas[low + 1] += weight * share;
    }
    for (int k = 0; k <= LAST; k++) {
        float span = 0.5 * (path.lengths[min(k + 1, LAST)] - path.lengths[max(k - 1, 0)]);
        widths[k] = float(areas[k]) / (16.0 * 255.0) / max(span, SHORTEST_PX / float(LAST));
    }
    return float(far) / float(max(all, 1u));
}

float width_at(float widths[RIBBON_POINTS], float u)
{
    float at = clamp(0.5 + 0.5 * u, 0.0, 1.0) * float(LAST), width = 0.0, sum = 0.0;
    for (int k = 0; k <= LAST; k++) {
        float share = max(1.0 - 0.5 * abs(at - float(k)), 0.0);
        width += share * widths[k];
        sum += share;
    }
    return width / sum;
}

float profile_at(float t)
{
    float at = clamp(t, 0.0, 1.0) * float(BRUSH_PROFILE - 1);
    int low = min(int(at), BRUSH_PROFILE - 2);
    return mix(profile[low], profile[low + 1], at - float(low));
}

// Returns the share of its length that a stroke keeps: a thin one is drawn shorter instead of thinner, and stays black.
float share_kept(float mean_width)
{
    return clamp(mean_width / max(thinnest, 1e-6), SHORTEST, 1.0);
}

// Returns u of both ends when a stroke goes on by `overdraw`, up to its own ends. It does not where the tone makes it
// end, which thins it out before; short parts go on by less.
// ends: u without that; thick: widths there, in mean widths
vec2 with_overdraw(Slot slot, Cubic cubic, vec2 ends, vec2 thick, float length_px)
{
    float speed = max(0.5 * length_px, 1.0); // pixels per u
    vec2 further = clamp(2.0 * thick - 1.0, 0.0, 1.0) * min(overdraw, 0.5 * length_px) / speed;
    further *= vec2((slot.joined & 4u) == 0u, (slot.joined & 8u) == 0u);
    vec2 own = vec2(u_of(cubic, 0.0), u_of(cubic, 1.0));
    return vec2(max(ends.x - further.x, min(own.x, ends.x)), min(ends.y + further.y, max(own.y, ends.y)));
}

// Returns the factor by which a stroke is wider so that it has its area in spite of the ends that taper (ribbon.frag),
// and of those that go on.
// seen, whole: length in pixels without and with these; count: of the ends that taper
float gain_of(float seen, float whole, int count)
{
    float taper = min(hand.w, 0.3 * whole * float(3 - count));
    return clamp(seen / max(whole - float(count) * taper / 3.0, SHORTEST_PX), 0.5, 2.0);
}

void main()
{
    uint i = gl_GlobalInvocationID.x;
    if (i >= count)
        return;
    Slot slot = slots[i];
    Cubic cubic = fit(slot.first, slot.count);
    Path path;
    float widths[RIBBON_POINTS];
    measure(cubic, -1.0, 1.0, path);
    missed[i] = find_widths(slot, cubic, path, widths);
    float mean = 0.0;
    for (int k = 0; k <= LAST; k++)
        mean += widths[k] / float(LAST + 1);
    float kept = share_kept(mean);
    vec2 ends = vec2(-1.0, 1.0), own = vec2(u_of(cubic, 0.0), u_of(cubic, 1.0));
    vec2 thick = vec2(width_at(widths, -1.0), width_at(widths, 1.0)) / max(mean, 1e-6);
    bool elsewhere = false;
    if (slot.joined == 0u && is_lapped(slot.first)) {
        elsewhere = has_middle_elsewhere(cubic, own, thick);
        ends = follow_both(cubic, own, thick);
    }
    float seen = kept * 0.5 * (ends.y - ends.x) * path.lengths[LAST];
    ends = with_overdraw(slot, cubic, ends, thick, path.lengths[LAST]);
    bvec2 whole_ends = bvec2(ends.x <= own.x, ends.y >= own.y);
    ends = 0.5 * (ends.x + ends.y) + 0.5 * kept * vec2(ends.x - ends.y, ends.y - ends.x);
    measure(cubic, ends.x, ends.y, path);
    float whole = max(path.lengths[LAST], SHORTEST_PX), thickest = min(1.0 + 0.5 * whole, WIDEST * pen.x); // no blots
    // An end of its own tapers as the texture's stroke does.
    uint tapered = (cubic.range.x < CUT || whole_ends.x ? 4u : 0u) | slot.joined;
    tapered |= cubic.range.y > 1.0 - CUT || whole_ends.y ? 8u : 0u;
    float gain = elsewhere ? 0.0 : gain_of(seen, whole, 2 - bitCount(tapered)) / kept;
    for (int k = 0; k <= LAST; k++) {
        vec2 way = path.places[min(k + 1, LAST)] - path.places[max(k - 1, 0)];
        vec2 across = vec2(-way.y, way.x) / max(length(way), 1e-6);
        float u = mix(ends.x, ends.y, float(k) / float(LAST));
        float t = mix(cubic.range.x, cubic.range.y, 0.5 + 0.5 * u), at = TURNS * t;
        float thickness = min(gain * width_at(widths, u) / profile_at(t), thickest);
        thickness *= 1.0 + hand.x * wave_noise(slot.high, at);
        float aside = hand.z * wave_noise(slot.high ^ 0x5bd1e995u, at);
        float pressure = matter.x * (1.0 - hand.y * (0.5 - 0.5 * wave_noise(slot.high ^ 0x27d4eb2fu, at)));
        uint bits = (slot.high & 0xfffffu) * 16u + (k == 0 ? 1u : 0u) + (k == LAST ? 2u : 0u) + tapered;
        uint to = 3u * (i * uint(RIBBON_POINTS) + uint(k));
        ribbon[to] = vec4(path.places[k] + aside * across, 0.5, 0.5 * thickness);
        ribbon[to + 1u] = vec4(pressure, float(bits), path.lengths[k], whole - path.lengths[k]);
        ribbon[to + 2u] = vec4(1.0, t, 1.0, 0.0);
    }
}
