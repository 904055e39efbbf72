// Fits a cubic to the sums of each stroke by conjugate gradients (Szecsi et al., Tonal Art Maps with Image Space
// Strokes, 2.2). A stroke has one width: the area of its fragments, divided by its length.
#include "strokes/drawn.glsl"

layout(local_size_x = 32) in;
#include "frame/index.glsl"
struct Slot {
    uint low, high, count, first, joined; // first: the slot in the table
};
layout(std430, binding = STORAGE_SLOTS) readonly buffer Slots { Slot slots[]; }; // without free ones
layout(binding = UNIT_TECHNIQUE) uniform sampler2D sums[5]; // outputs of blend.frag
layout(location = UNIFORM_COUNT) uniform uint count;

const int STEPS = 8; // twice as many as exact arithmetic needs: rounded directions are not quite conjugate
const float NEGLIGIBLE = 1e-13; // square of a residual, relative to the right side, which is rounded as much
const float SPARSEST = 5.0; // pixels of length per pixel of area; others are no stroke, but far pieces of one

// Solves A c = b, from the mean of the places.
vec4 solve(mat4 a, vec4 b)
{
    vec4 c = vec4(b.x / a[0].x, 0.0, 0.0, 0.0), rest = b - a * c, way = rest;
    float square = dot(rest, rest), least = NEGLIGIBLE * dot(b, b);
    for (int i = 0; i < STEPS && square > least; i++) {
        vec4 change = a * way;
        float rate = square / dot(way, change), before = square;
        c += rate * way;
        rest -= rate * change;
        square = dot(rest, rest);
        way = rest + square / before * way;
    }
    return c;
}

// Returns the factors of Legendre polynomials of u for a polynomial in powers of t = middle + half_range u.
vec4 shifted(vec4 c, float middle, float half_range)
{
    float h = half_range;
    vec4 d = vec4(c.x + middle * (c.y + middle * (c.z + middle * c.w)),
                  h * (c.y + middle * (2.0 * c.z + 3.0 * middle * c.w)), h * h * (c.z + 3.0 * middle * c.w),
                  h * h * h * c.w);
    return vec4(d.x + d.z / 3.0, d.y + 0.6 * d.w, 2.0 / 3.0 * d.z, 0.4 * d.w);
}

Cubic fit(ivec2 at)
{
    vec4 m = texelFetch(sums[0], at, 0), more = texelFetch(sums[1], at, 0);
    vec2 ends = texelFetch(sums[4], at, 0).xy * vec2(-1.0, 1.0);
    float middle = 0.5 * (ends.x + ends.y), half_range = 0.5 * (ends.y - ends.x);
    mat4 a = mat4(m, vec4(m.yzw, more.x), vec4(m.zw, more.xy), vec4(m.w, more.xyz));
    Cubic cubic;
    cubic.range = 0.5 + 0.5 * ends;
    cubic.origin = viewport.xy;
    cubic.x = shifted(solve(a, texelFetch(sums[2], at, 0)), middle, half_range);
    cubic.y = shifted(solve(a, texelFetch(sums[3], at, 0)), middle, half_range);
    cubic.weight = more.w;
    return cubic;
}

void main()
{
    uint i = index_of();
    if (i >= count)
        return;
    Slot slot = slots[i];
    uint width = uint(textureSize(sums[0], 0).x);
    ivec2 at = ivec2(slot.first % width, slot.first / width);
    Cubic cubic = fit(at);
    Path path;
    float widths[RIBBON_POINTS];
    measure(cubic, -1.0, 1.0, path);
    float length_px = path.lengths[LAST], width_px = cubic.weight / max(length_px, SHORTEST_PX);
    for (int k = 0; k <= LAST; k++)
        widths[k] = length_px < SPARSEST * cubic.weight ? width_px : 0.0;
    drawn_strokes[i] =
        Drawn(cubic, slot.high, stroke_number(slot.low), 0u, 0u, vec2(-1.0, 1.0), length_px, widths, width_px,
              magnified_along(path));
}
