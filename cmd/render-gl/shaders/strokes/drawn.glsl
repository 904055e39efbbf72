// Fitted strokes, and lengths and widths along them. Stages that fit write them; extrude.comp makes ribbons of them.
#include "frame/frame.glsl"
#include "traced/style.glsl"
#include "strokes/curve.glsl"
#include "strokes/hash.glsl"

const float WIDEST = 1.5; // greatest width, in widths of the pen where the map is not magnified
const float SHORTEST_PX = 1.0;
const uint JOINED_START = 4u, JOINED_END = 8u; // a stroke goes on before its start, after its end
const int LAST = RIBBON_POINTS - 1;

#ifdef MAGNIFIED
layout(binding = UNIT_MAGNIFIED) uniform sampler2D magnified; // gather_map.frag
#endif

struct Path {
    vec2 places[RIBBON_POINTS];
    float lengths[RIBBON_POINTS]; // from the first
};

// A stroke to draw. u runs from -1 to 1 over the part in sight.
struct Drawn {
    Cubic cubic;
    uint high;   // upper word of its id
    uint number; // that of the stroke of which it is a part; 20 bits
    uint joined; // bits JOINED_...
    uint own;    // the same bits: the end is the stroke's own, and tapers as that of the texture does
    vec2 ends;   // u of both ends, without overdraw
    float length_px; // from u -1 to 1
    float widths[RIBBON_POINTS]; // at evenly spaced u from -1 to 1
    float mean;                  // of the widths
    float magnified;             // pixels per texel of its map, at least 1
};

layout(std430, binding = STORAGE_DRAWN) buffer Strokes { Drawn drawn_strokes[]; };

// Returns by how much the map is magnified along a path at most, at least 1.
float magnified_along(Path path)
{
    float most = 1.0;
#ifdef MAGNIFIED
    for (int k = 0; k <= LAST; k++) {
        vec2 place = clamp(path.places[k], vec2(0.0), vec2(textureSize(magnified, 0) - 1));
        most = max(most, texelFetch(magnified, ivec2(place), 0).r);
    }
#endif
    return most;
}

void measure(Cubic cubic, float from, float to, out Path path)
{
    for (int k = 0; k <= LAST; k++) {
        path.places[k] = place_on(cubic, mix(from, to, float(k) / float(LAST)));
        path.lengths[k] = k == 0 ? 0.0 : path.lengths[k - 1] + distance(path.places[k], path.places[k - 1]);
    }
}

float mean_of(float widths[RIBBON_POINTS])
{
    float mean = 0.0;
    for (int k = 0; k <= LAST; k++)
        mean += widths[k] / float(LAST + 1);
    return mean;
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

// Returns the widths at both ends, in mean widths.
vec2 thickness_of(float widths[RIBBON_POINTS], float mean)
{
    return vec2(width_at(widths, -1.0), width_at(widths, 1.0)) / max(mean, 1e-6);
}
