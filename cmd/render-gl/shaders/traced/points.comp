// Computes the place, the width and the ink of each point of the strokes on an item.
#include "frame/light.glsl"
#include "traced/style.glsl"
#include "traced/width.glsl"
#include "traced/marks.glsl"

layout(local_size_x = 64) in;
#include "frame/index.glsl"
layout(std430, binding = STORAGE_VERTICES) readonly buffer Vertices { float vertices[]; }; // 10 each
struct Placed {
    vec4 clip;
    vec4 amounts;
};
layout(std430, binding = STORAGE_PLACED) readonly buffer PlacedVertices { Placed placed[]; };
struct Point { // struct traced_point of technique/traced/traced.h
    uvec4 corners; // three vertices; hash of the stroke
    vec4 at;       // shares of corners 1 and 2; change of these shares per mesh unit along the stroke
    vec4 stroke;   // threshold; doubled area of the face; arc length from the start and to the end of the stroke
    vec4 rest;     // family; bits 1: first, 2: last of its stroke, 4, 8: its start, its end is not free;
                   // turn with its neighbours, -1 .. 1; greatest length of its pointed ends, in mesh units
    vec4 across;   // way across a narrow face, as a change of both shares; 1 + the family that crosses it, or 0;
                   // greatest density on its part of the mesh, as a share of that of the mesh
};
layout(std430, binding = STORAGE_POINTS) readonly buffer Points { Point points[]; };
layout(std430, binding = STORAGE_RIBBON) writeonly buffer Ribbon {
    vec4 ribbon[]; // TRACED_RIBBON_FLOATS of technique/traced/traced.h
};
layout(location = UNIFORM_COUNT) uniform uint count;
layout(location = UNIFORM_LIFT) uniform vec4 lift; // change of clip z and w per unit towards the eye; units by which
                                                   // strokes are moved so; -1: the item is mirrored, else 1
layout(location = UNIFORM_INK) uniform int ink_index;
layout(location = UNIFORM_DEPTHS) uniform bool has_depths;
layout(binding = UNIT_TECHNIQUE + 1) uniform sampler2D depths; // of the surfaces, in samples
layout(location = UNIFORM_DENSEST) uniform vec3 densest; // of all strokes, for width_law; coarsest gap, in mesh units:
                                                         // the unit of arc lengths in ribbons

const vec2 NARROW_PX = vec2(40.0, 60.0); // width of narrow faces, and of others
const float TURNED_MOST_PX = 8.0;
const float TURNED_GAPS = 10.0; // between drawn strokes: half a stroke that is longer is turned aside no farther than this
const float SPARSEST = 32.0; // factor up to which dots fill the gaps between sparse strokes
const float ASIDE = 0.15; // pixels towards the eye per pixel aside
const float NEAREST = 4.0; // depth up to which points before the near plane are placed; it is 1 at that plane
const float WALL_PX = 24.0; // thickness up to which strokes on the back of a wall could come through it when they are lifted
const float BESIDE_PX = 0.1; // by which the face beside may be nearer, on a surface that faces the eye
const float STEEPEST = 6.0; // slope of the surface, as seen, up to which strokes are lifted by all of their half width

vec3 floats_at(uint vertex, uint offset)
{
    uint at = 10u * vertex + offset;
    return vec3(vertices[at], vertices[at + 1u], vertices[at + 2u]);
}

vec3 mixed(uvec4 corners, vec3 shares, uint offset)
{
    return shares.x * floats_at(corners.x, offset) + shares.y * floats_at(corners.y, offset) +
           shares.z * floats_at(corners.z, offset);
}

#ifdef BASE_TONE
float base_light(uvec4 corners, vec3 shares)
{
    vec2 at = vec2(0.0);
    for (int c = 0; c < 3; c++)
        at += shares[c] * vec2(vertices[10u * corners[c] + 8u], vertices[10u * corners[c] + 9u]);
    return dot(textureLod(base_texture, at, 0.0).rgb, vec3(0.2126, 0.7152, 0.0722));
}
#endif

// Returns the amounts of both inks. behind: the surface is seen from behind.
vec2 amounts_at(uvec4 corners, vec3 shares, bool behind)
{
#ifdef BASE_TONE
    float texture_light = base_light(corners, shares);
#else
    const float texture_light = 1.0;
#endif
#ifdef PIXEL_LIGHT
    vec3 point = (unit_from_mesh * vec4(mixed(corners, shares, 0u), 1.0)).xyz;
    vec3 normal = normal_from_mesh * mixed(corners, shares, 3u);
    vec3 first = floats_at(corners.x, 0u);
    vec3 face = normal_from_mesh * cross(floats_at(corners.y, 0u) - first, floats_at(corners.z, 0u) - first);
    float facing = behind ? -1.0 : 1.0;
    normal *= facing / max(length(normal), 1e-20);
    face *= facing / max(length(face), 1e-30);
    return ink_amounts(light_at(point, normal, face) * base.x * texture_light);
#else
    vec4 all = shares.x * placed[corners.x].amounts + shares.y * placed[corners.y].amounts +
               shares.z * placed[corners.z].amounts;
    vec2 amounts = behind ? all.zw : all.xy;
#ifdef BASE_TONE
    amounts = ink_amounts(amounts.x * texture_light);
#endif
    return amounts;
#endif
}

// Returns the change in pixels, and of depth, along an edge of the face.
vec3 slope_along(vec4 edge, vec4 at)
{
    return (edge.xyz - at.xyz / at.w * edge.w) / at.w * vec3(viewport.xy, 1.0);
}

// Returns the change of clip x per unit to the right. The matrix of a tile adds a multiple of its last row to the first.
float right_length()
{
    vec3 first = vec3(clip_from_unit[0].x, clip_from_unit[1].x, clip_from_unit[2].x);
    vec3 last = vec3(clip_from_unit[0].w, clip_from_unit[1].w, clip_from_unit[2].w);
    return length(first - dot(first, last) * last);
}

// Returns whether a surface is just before a place. The face beside that of the place is not one.
// gradient: of the place's depth, per pixel; flat_rise: change of depth along a pixel towards the eye
bool is_behind_wall(vec3 place, vec2 gradient, float flat_rise)
{
    vec2 samples = vec2(textureSize(depths, 0)) / (2.0 * viewport.xy); // per pixel
    ivec2 texel = ivec2(floor(place.xy * samples)), at = clamp(texel, ivec2(0), textureSize(depths, 0) - 1);
    if (any(greaterThan(abs(texel - at), ivec2(WALL_PX * samples)))) // just beside the picture its border tells
        return false;
    float own = place.z + dot(gradient, (vec2(at) + 0.5) / samples - place.xy);
    float nearer = (texelFetch(depths, at, 0).r - own) / flat_rise;
    return nearer > BESIDE_PX * (1.0 + length(gradient) / flat_rise) && nearer < WALL_PX;
}

void main()
{
    uint i = index_of();
    if (i >= count)
        return;
    Point point = points[i];
    uvec4 corners = point.corners;
    vec3 shares = vec3(1.0 - point.at.x - point.at.y, point.at.xy);
    vec4 origin = placed[corners.x].clip, edge_1 = placed[corners.y].clip - origin;
    vec4 edge_2 = placed[corners.z].clip - origin, at = origin + shares.y * edge_1 + shares.z * edge_2;
    uint stroke = corners.w & 0xfffffu;
    ribbon[3u * i] = vec4(0.0, 0.0, 0.0, -1.0);
    vec2 to_ends = point.stroke.zw / densest.z;
    ribbon[3u * i + 1u] = vec4(0.0, float(stroke * 16u) + point.rest.y, to_ends);
    ribbon[3u * i + 2u] = vec4(0.0);
    if (at.w <= 0.0 || at.z >= NEAREST * at.w)
        return; // other places before the near plane and beyond the far one are clipped
    vec3 along_1 = slope_along(edge_1, at), along_2 = slope_along(edge_2, at);
    float area = (along_1.x * along_2.y - along_1.y * along_2.x); // doubled, in square pixels; negative: from behind
    vec3 way = point.at.z * along_1 + point.at.w * along_2; // per mesh unit along the stroke
    float length_px = max(length(way.xy), 1e-20);
    vec3 place = vec3((at.xy / at.w * 0.5 + 0.5) * 2.0 * viewport.xy, at.z / at.w);
    ribbon[3u * i] = vec4(place, 0.0);
    float gap_px = length_px * densest.z;
    ribbon[3u * i + 2u] = vec4(gap_px, log2(gap_px / period_px(marks, 0.5)), 0.0, 0.0);
    bool behind = area * lift.w < 0.0;
    if (behind && side > 0.0)
        return;
    float toward_eye = (lift.x - place.z * lift.y) / at.w; // change of depth per unit towards the eye
    float unit_px = right_length() * viewport.x / at.w, flat_rise = toward_eye / unit_px;
    float scale = abs(area) / (point.stroke.y * length_px);
    float denser = grazing_factor(scale, length(vec2(length_px, way.z / flat_rise)), matter.z);
    float narrow = 0.0;
    if (point.across.z > 0.0)
        narrow = 1.0 - smoothstep(NARROW_PX.x, NARROW_PX.y, length(point.across.x * along_1.xy + point.across.y * along_2.xy));
    float tone = tone_of(int(point.rest.x), amounts_at(corners, shares, behind)[ink_index], int(point.across.z) - 1, narrow);
    bool dots = marks.w > 0.0;
    vec2 reached = vec2(densest.x * point.across.w, densest.y);
    vec3 law = width_law(pen.xy, stroke_tone(marks, tone), point.stroke.x, scale, reached, denser, dots);
    float width = law.x * (dots ? float(law.y > 0.0) : law.y), sparser = dots ? min(law.z, SPARSEST) : 1.0;
    float period = period_px(marks, tone), scatter = marks.z * period * sparser;
    period /= sparser;
    vec2 ends = to_ends * gap_px;
    float octave = log2(gap_px / 48.0); // of the noise whose waves are about 48 pixels long
    float along = to_ends.x / max(to_ends.x + to_ends.y, 1e-20); // as a share of the stroke
    width *= look_profile(0, along) / zigzag.w;
    width *= 1.0 + hand.x * (0.7 * stroke_noise(corners.w, to_ends.x, octave) +
                             0.3 * stroke_noise(corners.w ^ 0x165667b1u, to_ends.x, octave + 1.0));
    vec2 gradient = vec2(along_1.z * along_2.y - along_2.z * along_1.y, along_2.z * along_1.x - along_1.z * along_2.x) /
                    (abs(area) > 1e-12 ? area : 1e-12); // of depth, per pixel
    vec2 across = vec2(-way.y, way.x) / length_px;
    float turned = min(TURNED_GAPS * law.x / max(tone, 0.05), TURNED_MOST_PX / max(pen.w, 1e-6));
    float wobble = hand.z * (0.4 * stroke_noise(corners.w ^ 0x5bd1e995u, to_ends.x, octave) +
                             0.6 * stroke_noise(corners.w ^ 0x2545f491u, to_ends.x, octave - 2.0)) +
                   pen.w * point.rest.z * turned * tanh(0.5 * (ends.x - ends.y) / turned);
    float rise = dot(gradient, across), steep = length(gradient) / flat_rise;
    scatter /= 1.0 + steep * steep / 25.0; // and dots, which are farther away, less so
    if (behind) // next to silhouettes, the front is too near to tell them apart
        width *= has_depths && is_behind_wall(place, gradient, flat_rise) ? 0.0 : clamp(2.0 - 0.25 * steep, 0.0, 1.0);
    float reach = min(abs(rise), STEEPEST * flat_rise) * (0.5 * width + scatter + 1.0);
    wobble /= 1.0 + steep * steep; // strokes stay inside of silhouettes
    reach += ASIDE * abs(wobble) * flat_rise * (1.0 + steep); // beside its own place, it is over faces of other slopes
    place.xy += wobble * across;
    float slant = length(vec2(1.0, min(steep, STEEPEST))); // lines pass under the surface along its normal
    place.z += wobble * rise + reach + lift.z * toward_eye * slant;
    float lightening = 0.5 - 0.5 * stroke_noise(corners.w ^ 0x27d4eb2fu, to_ends.x, octave);
    float pressure = matter.x * (1.0 - hand.y * lightening) * look_profile(1, along);
    ribbon[3u * i] = vec4(place, 0.5 * width);
    ribbon[3u * i + 1u].x = pressure;
    float pointed = min(point.rest.w * length_px / hand.w, 1.0);
    ribbon[3u * i + 2u] = vec4(gap_px, log2(gap_px / period), dots ? law.y : pointed, scatter);
}
