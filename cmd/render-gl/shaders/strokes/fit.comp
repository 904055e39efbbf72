// Fits a cubic to the fragments of each stroke. A stroke is as wide as its fragments say: the area that they cover,
// divided by its length.
#include "strokes/drawn.glsl"
#include "strokes/fragments.glsl"
#include "strokes/cubic.glsl"
#include "strokes/patches.glsl"

layout(local_size_x = 32) in;
#include "frame/index.glsl"
struct Slot {
    uint low, high, count, first, joined; // joined: bits JOINED_... of strokes/extrude.glsl
};
layout(std430, binding = STORAGE_SLOTS) readonly buffer Slots { Slot slots[]; }; // without free ones
layout(std430, binding = STORAGE_MISSED) writeonly buffer Missed { vec2 missed[]; }; // share of the weight; magnification
layout(std430, binding = STORAGE_ORDER) readonly buffer Order { uint order[]; }; // indices of the slots to fit
layout(location = UNIFORM_COUNT) uniform uint count; // of these

const float REACH = 1.5; // distance of a stroke's fragments from its curve, in widths of the pen, and a pixel
const float CUT = 0.04;  // share of t by which a stroke that is cut off falls short of its own end

// Computes the width of the visible part at evenly spaced u: the area of the fragments around there by the length.
// Fragments that the curve does not reach have no part in it; returns their share of the weight.
// larger: magnification
float find_widths(Slot slot, Cubic cubic, Path path, float larger, out float widths[RIBBON_POINTS])
{
    uint far = 0u, all = 0u, areas[RIBBON_POINTS]; // integers, whose sums do not depend on the order of the fragments
    for (int k = 0; k <= LAST; k++)
        areas[k] = 0u;
    for (uint i = slot.first; i < slot.first + slot.count; i++) {
        float u = u_of(cubic, t_of(sorted[i])), at = clamp(0.5 + 0.5 * u, 0.0, 1.0) * float(LAST);
        int low = min(int(at), LAST - 1);
        uint share = uint((at - float(low)) * 16.0 + 0.5), weight = sorted[i].y >> 24;
        all += weight;
        if (distance(place_on(cubic, u), pixel_of(sorted[i])) > larger * (REACH * pen.x + 1.0)) {
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

// Makes a dot of a stroke that is shorter than wide: a square of the same area. Returns whether it is one.
bool make_dot(float larger, inout Cubic cubic, inout Path path, inout float widths[RIBBON_POINTS])
{
    float side = clamp(sqrt(cubic.weight), SHORTEST_PX, larger * WIDEST * pen.x);
    if (path.lengths[LAST] >= side)
        return false;
    vec2 middle = place_on(cubic, 0.0) - cubic.origin, way = path.places[LAST] - path.places[0];
    vec2 along = length(way) > 1e-3 ? normalize(way) : vec2(1.0, 0.0);
    cubic.x = vec4(middle.x, 0.5 * side * along.x, 0.0, 0.0);
    cubic.y = vec4(middle.y, 0.5 * side * along.y, 0.0, 0.0);
    path.lengths[LAST] = side;
    for (int k = 0; k <= LAST; k++)
        widths[k] = cubic.weight / side;
    return true;
}

void main()
{
    if (index_of() >= count)
        return;
    uint i = order[index_of()];
    Slot slot = slots[i];
    Cubic cubic = fit(slot.first, slot.count);
    Path path;
    float widths[RIBBON_POINTS];
    measure(cubic, -1.0, 1.0, path);
    float larger = magnified_along(path);
    missed[i] = vec2(find_widths(slot, cubic, path, larger, widths), larger);
    bool is_dot = make_dot(larger, cubic, path, widths);
    float mean = mean_of(widths);
    vec2 ends = vec2(-1.0, 1.0), own = vec2(u_of(cubic, 0.0), u_of(cubic, 1.0)), thick = thickness_of(widths, mean);
    if (!is_dot && slot.joined == 0u && is_lapped(slot.first)) {
        ends = follow_both(cubic, own, thick);
        if (has_middle_elsewhere(cubic, own, thick))
            for (int k = 0; k <= LAST; k++)
                widths[k] = 0.0;
    }
    uint whole = (cubic.range.x < CUT ? JOINED_START : 0u) | (cubic.range.y > 1.0 - CUT ? JOINED_END : 0u);
    if (is_dot)
        whole = JOINED_START | JOINED_END;
    drawn_strokes[i] = Drawn(cubic, slot.high, stroke_number(slot.low), slot.joined, whole, ends, path.lengths[LAST],
                             widths, mean, larger);
}
