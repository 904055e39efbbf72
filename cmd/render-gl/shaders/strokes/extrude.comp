// Makes a ribbon of each fitted stroke: RIBBON_POINTS points for traced/ribbon.vert.
#include "strokes/drawn.glsl"
#include "traced/noise.glsl"

layout(local_size_x = 32) in;
#include "frame/index.glsl"
layout(std430, binding = STORAGE_RIBBON) writeonly buffer Ribbon { vec4 ribbon[]; };
layout(location = UNIFORM_COUNT) uniform uint count;
layout(location = UNIFORM_PROFILE) uniform float profile[BRUSH_PROFILE]; // mean ink along a stroke
layout(location = UNIFORM_THINNEST) uniform float thinnest; // least mean width of strokes that are drawn whole
layout(location = UNIFORM_OVERDRAW) uniform float overdraw; // pixels by which strokes go on where they are cut off
layout(location = UNIFORM_MARGIN) uniform float margin; // of the tile in which fragments are gathered

const float SHORTER = 0.75; // exponent of the length of a thin stroke; 1: only the length changes with the ink
const float SHORTEST = 0.3; // least share of its length that a thin stroke keeps
const float SHORT_WIDTHS = 3.0; // a stroke of so many widths of the pen keeps its length
const vec2 LONG = vec2(2.0, 4.0); // widths of the pen from which on a stroke goes on, and goes on by all of overdraw
const float TURNS = 4.0;    // waves of the noise along a whole stroke

float profile_at(float t)
{
    float at = clamp(t, 0.0, 1.0) * float(BRUSH_PROFILE - 1);
    int low = min(int(at), BRUSH_PROFILE - 2);
    return mix(profile[low], profile[low + 1], at - float(low));
}

// Returns the share of its length that a stroke keeps: a thin one gets rather shorter than thinner, and stays black.
float share_kept(Drawn drawn)
{
    float share = pow(max(drawn.mean, 0.0) / max(drawn.magnified * thinnest, 1e-6), SHORTER);
    return drawn.length_px < SHORT_WIDTHS * drawn.magnified * pen.x ? 1.0 : clamp(share, SHORTEST, 1.0);
}

// Returns u of both ends when a stroke goes on by `overdraw`, up to its own ends. It does not where the tone makes it
// end, which thins it out before; short parts go on by less, and dots not at all: the few pixels of one seldom reach
// t of 0 and 1, and its tangents are steep.
vec2 with_overdraw(Drawn drawn)
{
    float speed = max(0.5 * drawn.length_px, 1.0); // pixels per u
    vec2 further = clamp(2.0 * thickness_of(drawn.widths, drawn.mean) - 1.0, 0.0, 1.0);
    further *= min(overdraw, 0.5 * drawn.length_px) / speed;
    further *= smoothstep(LONG.x, LONG.y, drawn.length_px / (drawn.magnified * pen.x));
    further *= vec2((drawn.joined & JOINED_START) == 0u, (drawn.joined & JOINED_END) == 0u);
    vec2 own = vec2(u_of(drawn.cubic, 0.0), u_of(drawn.cubic, 1.0)), ends = drawn.ends;
    return vec2(max(ends.x - further.x, min(own.x, ends.x)), min(ends.y + further.y, max(own.y, ends.y)));
}

// Returns the factor by which a stroke is wider so that it has its area in spite of the ends that taper (ribbon.frag),
// and of those that go on.
// seen, whole: length in pixels without and with these; free: 1 for an end that tapers, else 0; thick: widths at the
// ends, in mean widths
float gain_of(float seen, float whole, vec2 free, vec2 thick)
{
    float taper = min(hand.w, 0.3 * whole * (3.0 - free.x - free.y));
    float lost = dot(free, clamp(thick, 0.0, 1.0)) * taper / 3.0;
    return clamp(seen / max(whole - lost, SHORTEST_PX), 0.5, 2.0);
}

// Returns the level of a zigzag whose waves have their own length (look.glsl).
float wave_level(Drawn drawn)
{
    float whole = drawn.length_px / max(drawn.cubic.range.y - drawn.cubic.range.x, 1e-3);
    return zigzag.x > 0.0 && zigzag.z == 0.0 ? log2(max(whole, 1.0) / zigzag.y) : 0.0;
}

// Writes point k of a ribbon.
// factor: of the widths; blunt: bits 4, 8: ends that the pen does not taper
void put_point(uint to, int k, Drawn drawn, Path path, float u, float factor, uint blunt)
{
    float whole = max(path.lengths[LAST], SHORTEST_PX), thickest = min(1.0 + whole, drawn.magnified * WIDEST * pen.x); // no blots
    vec2 way = path.places[min(k + 1, LAST)] - path.places[max(k - 1, 0)];
    vec2 across = vec2(-way.y, way.x) / max(length(way), 1e-6);
    float t = mix(drawn.cubic.range.x, drawn.cubic.range.y, 0.5 + 0.5 * u), at = TURNS * t;
#ifdef FLAT // strokes that do not darken each other are as wide as those of the map, however little ink they have
    thickest /= profile_at(t);
#endif
    float thickness = min(factor * width_at(drawn.widths, u) / profile_at(t), thickest);
    thickness *= (1.0 + hand.x * wave_noise(drawn.high, at)) * look_profile(0, t) / zigzag.w;
    float aside = hand.z * wave_noise(drawn.high ^ 0x5bd1e995u, at);
    float pressure = matter.x * (1.0 - hand.y * (0.5 - 0.5 * wave_noise(drawn.high ^ 0x27d4eb2fu, at)));
    pressure *= look_profile(1, t);
    uint bits = drawn.number * 16u + (k == 0 ? 1u : 0u) + (k == LAST ? 2u : 0u) + blunt;
    ribbon[to] = vec4(path.places[k] - margin + aside * across, 0.5, 0.5 * thickness);
    ribbon[to + 1u] = vec4(pressure, float(bits), path.lengths[k], whole - path.lengths[k]);
    ribbon[to + 2u] = vec4(1.0, t, wave_level(drawn), 0.0);
}

void main()
{
    uint i = index_of();
    if (i >= count)
        return;
    Drawn drawn = drawn_strokes[i];
    float kept = share_kept(drawn);
    float seen = kept * 0.5 * (drawn.ends.y - drawn.ends.x) * drawn.length_px;
    vec2 ends = with_overdraw(drawn);
    uint blunt = drawn.own | drawn.joined;
    ends = 0.5 * (ends.x + ends.y) + 0.5 * kept * vec2(ends.x - ends.y, ends.y - ends.x);
    Path path;
    measure(drawn.cubic, ends.x, ends.y, path);
    vec2 free = vec2((blunt & JOINED_START) == 0u, (blunt & JOINED_END) == 0u);
    vec2 thick = thickness_of(drawn.widths, drawn.mean);
    float factor = gain_of(seen, max(path.lengths[LAST], SHORTEST_PX), free, thick) / kept;
    for (int k = 0; k <= LAST; k++)
        put_point(3u * (i * uint(RIBBON_POINTS) + uint(k)), k, drawn, path, mix(ends.x, ends.y, float(k) / float(LAST)),
                  factor, blunt);
}
