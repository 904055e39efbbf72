// The marks that a stroke is drawn in: libhatch/curve/marks.h, where they are explained. The vector `marks` is that of
// traced/style.glsl.
#include "traced/noise.glsl"

const int BITS = 3, ANCESTORS = 4;
const float SOFT = 0.2, SHARE_SOFT = 0.08, MARGIN = 0.5, DOT_LAYERS = 2.5, PASSING = 0.6;

uint hash_cell(uint stroke, int level, uint cell)
{
    return mix_bits(stroke + uint(level) * 0x9e3779b9u + cell * 0x85ebca6bu);
}

float draw_of(uint number, uint which)
{
    return float(number >> 10u * which & 1023u) / 1023.0;
}

float grown(float share, float number, float soft)
{
    float limit = share + 0.5 * soft;
    limit = share < 0.5 * soft ? sqrt(2.0 * soft * max(share, 0.0)) : limit;
    limit = share > 1.0 - 0.5 * soft ? 1.0 + soft - sqrt(2.0 * soft * max(1.0 - share, 0.0)) : limit;
    return clamp((limit - number) / soft, 0.0, 1.0);
}

// Returns the place within a cell, in cells from its start, and its weight.
vec2 place_of(uint stroke, int level, uint cell, float part)
{
    uint parent = hash_cell(stroke, level - 1, cell >> 1), below = cell;
    float within = 0.0, size = 0.5, weight = 1.0;
    if ((cell & 1u) != parent >> 31)
        weight = grown(exp2(part) - 1.0, float(parent & 0xffffffu) / 16777216.0, SOFT);
    if (weight <= 0.0)
        return vec2(0.0);
    for (int n = 0; n < BITS; n++) {
        uint bit = hash_cell(stroke, level + n, below) >> 31;
        below = 2u * below + bit;
        within += float(bit) * size * (n + 1 < BITS ? 1.0 : part);
        size *= 0.5;
    }
    return vec2(within, weight);
}

uint number_of(uint stroke, int level, uint cell)
{
    for (int n = 0; n < ANCESTORS && (cell & 1u) == hash_cell(stroke, level - 1, cell >> 1) >> 31; n++) {
        cell >>= 1;
        level--;
    }
    return hash_cell(stroke ^ 0x5bd1e995u, level, cell);
}

float period_px(vec4 marks, float tone)
{
    float period = marks.x <= 0.0 ? 1.0 : marks.x + marks.y;
    return marks.w > 0.0 ? period * sqrt(0.5 / max(DOT_LAYERS * tone, 1e-4)) : period;
}

float stroke_tone(vec4 marks, float tone)
{
    return marks.w > 0.0 ? DOT_LAYERS * tone * period_px(marks, tone) / marks.x : tone;
}

// A fragment of a stroke. Lengths are in pixels but for `at`.
struct Spot {
    uint stroke;
    float at, scale, level; // arc length; struct hatch_mark_point
    float across, to_start, to_end;
    float half_width, scatter;
    float side; // samples per pixel
};

// Returns the share of a sample that the dots around a spot cover. share: of the dots that are drawn
float dots_cover(vec4 marks, Spot spot, float share)
{
    float low = floor(spot.level), covered = 0.0;
    int level = int(low) + 1;
    float cell_px = spot.scale * exp2(-float(level)), at = spot.at * exp2(float(level));
    float core = max(0.5 * marks.x - spot.half_width, 0.0), reach = 1.15 * spot.half_width + core + 0.5 / spot.side;
    float last = min(at + reach / cell_px, floor(at) + 96.0);
    for (float cell = max(floor(at - reach / cell_px), 0.0); cell <= last; cell += 1.0) {
        vec2 place = place_of(spot.stroke, level, uint(cell), spot.level - low);
        float away = (cell + place.x - at) * cell_px;
        if (place.y <= 0.0 || abs(away) > reach || min(spot.to_start + away, spot.to_end - away) < 0.5 * marks.x)
            continue;
        uint random = number_of(spot.stroke, level, uint(cell));
        float weight = place.y * grown(share, draw_of(random, 0u), SHARE_SOFT);
        float radius = spot.half_width * sqrt(weight) * (0.85 + 0.3 * draw_of(random, 2u));
        float beside = spot.scatter * (2.0 * draw_of(random, 1u) - 1.0);
        float distance = length(vec2(max(abs(away) - core * weight, 0.0), spot.across - beside));
        covered = max(covered, clamp((radius - distance) * spot.side + 0.5, 0.0, 1.0) * min(4.0 * weight, 1.0));
    }
    return covered;
}

// Returns the share of a sample's width that a line covers.
float line_cover(float half_width, float across, float side)
{
    return clamp(min(half_width, across + 0.5 / side) - max(-half_width, across - 0.5 / side), 0.0, 1.0 / side) * side;
}

// Finds the next joint from a spot, to the left (step -1) or to the right (1): its distance in pixels and weight; 0
// weight: there is none nearby.
vec2 joint_from(vec4 marks, Spot spot, int level, float part, int step, out uint number)
{
    float cells = exp2(float(level)), cell_px = spot.scale / cells, at = spot.at * cells, cell = floor(at);
    number = 0u;
    for (int n = 0; n < 4 && cell >= 0.0; n++, cell += float(step)) {
        vec2 place = place_of(spot.stroke, level, uint(cell), part);
        float away = (cell + place.x - at) * cell_px;
        if (step < 0 ? away > 0.0 : away <= 0.0)
            continue;
        float to_end = min(spot.to_start + away, spot.to_end - away);
        place.y *= clamp(4.0 * (to_end / period_px(marks, 0.5) - MARGIN), 0.0, 1.0);
        if (place.y <= 0.0)
            continue;
        number = number_of(spot.stroke, level, uint(cell));
        return vec2(abs(away), place.y);
    }
    return vec2(1e6, 0.0);
}

// Returns the share of a sample that the marks around a spot cover. taper: length of the pointed ends of a mark
float marks_cover(vec4 marks, Spot spot, float taper)
{
    float low = floor(spot.level), part = spot.level - low;
    int level = int(low) + 1;
    uint left, right;
    vec2 before = joint_from(marks, spot, level, part, -1, left);
    vec2 after = joint_from(marks, spot, level, part, 1, right);
    float half_before = 0.5 * before.y * marks.y * (0.6 + 0.8 * draw_of(left, 0u));
    float half_after = 0.5 * after.y * marks.y * (0.6 + 0.8 * draw_of(right, 0u));
    float starts = spot.scatter * before.y * (2.0 * draw_of(left, 2u) - 1.0);
    float ends = spot.scatter * after.y * (2.0 * draw_of(right, 1u) - 1.0);
    float way = before.y > 0.0 ? before.x : spot.to_start, rest = after.y > 0.0 ? after.x : spot.to_end;
    vec2 sharp = clamp(vec2(before.x - half_before, after.x - half_after) / taper, 0.0, 1.0);
    sharp = mix(vec2(1.0), sharp * (2.0 - sharp), vec2(before.y, after.y));
    float beside = mix(starts, ends, clamp(way / max(way + rest, 1e-6), 0.0, 1.0));
    float covered = line_cover(spot.half_width * min(sharp.x, sharp.y), spot.across - beside, spot.side);
    if (marks.y < 0.0) { // the end of the mark before, or the start of the one after
        bool first = before.x < after.x;
        float over = clamp((first ? -half_before - before.x : -half_after - after.x) / taper, 0.0, 1.0);
        beside = first ? spot.scatter * before.y * (2.0 * draw_of(left, 1u) - 1.0)
                       : spot.scatter * after.y * (2.0 * draw_of(right, 2u) - 1.0);
        covered = max(covered, line_cover(spot.half_width * over * (2.0 - over), spot.across - beside, spot.side));
    }
    return covered;
}
