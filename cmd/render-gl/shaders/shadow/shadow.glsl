// Defines lit_share(), which returns the share of a light that reaches a point. It is the mean of depth comparisons
// over a disk in the plane of the surface, so that a plane casts no shadow on itself at any angle.
#ifdef SHADOWS
#include "shadow/block.glsl"

layout(binding = UNIT_SHADOWS) uniform sampler2DArrayShadow shadow_maps;

layout(binding = UNIT_SHADOW_TEXELS) uniform sampler2DArrayShadow shadow_texels; // the same, unfiltered

// Depths are compared at pairs of opposite points, spread evenly over the unit disk at golden angles of the half
// circle. An edge through the disk's middle therefore separates half of the points. The outermost pairs come first,
// because usually they decide whether more are needed.
const int PAIRS = 8, FIRST_PAIRS = 4;
const mat2 TURN = mat2(-0.36237, 0.93203, -0.93203, -0.36237); // rotation by 111.25 degrees

vec2 tap(int i, vec2 way)
{
    return sqrt(1.0 - (float(i) + 0.5) / float(PAIRS)) * way;
}

// Returns the slope of the surface in a map: the change of depth per unit of x and of y. face: its geometric normal.
#ifdef SUN
vec2 depth_slope(mat4 map, vec4 at, vec3 face)
{
    mat3 rows = transpose(mat3(map)); // orthogonal, of different lengths
    vec3 across = face * rows / vec3(dot(rows[0], rows[0]), dot(rows[1], rows[1]), dot(rows[2], rows[2]));
    return abs(across.z) > 1e-12 ? -across.xy / across.z : vec2(0.0);
}
#else
vec2 depth_slope(mat4 map, vec4 at, vec3 face)
{
    vec3 along = normalize(cross(face, abs(face.y) < 0.9 ? vec3(0.0, 1.0, 0.0) : vec3(1.0, 0.0, 0.0)));
    vec4 a = map * vec4(along, 0.0), b = map * vec4(cross(face, along), 0.0);
    vec3 place = at.xyz / at.w;
    vec3 x = a.xyz - place * a.w, y = b.xyz - place * b.w;
    float area = x.x * y.y - y.x * x.y;
    return abs(area) > 1e-12 ? vec2(x.z * y.y - y.z * x.y, y.z * x.x - x.z * y.x) / area : vec2(0.0);
}
#endif

int cube_face(vec3 away)
{
    vec3 size = abs(away);
    int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
    return 2 * axis + (away[axis] < 0.0 ? 1 : 0);
}

// Returns the coordinates to read beside a place. border: least distance of a read from the sides of the map; under 0:
// reads may be beyond them.
vec4 read_at(vec3 place, vec2 slope, vec2 away, float layer, float border)
{
#ifndef SUN
    away = border < 0.0 ? away : clamp(place.xy + away, border, 1.0 - border) - place.xy;
#endif
    return vec4(place.xy + away, layer, min(place.z + dot(slope, away), 1.0)); // empty parts of maps hold 1
}

// Returns the share of light around a place in a map. If the first pairs agree, they are the result. Otherwise an edge
// is near, and all pairs are read with filtering. The second part is a loop rather than an `if`, because software
// renderers skip empty loops; offsets are computed, because those renderers copy a constant table on every use.
float share_around(vec3 place, vec2 slope, vec2 spread, float layer, float border)
{
    float some = 0.0, sum = 0.0;
    vec2 way = vec2(1.0, 0.0);
    for (int i = 0; i < FIRST_PAIRS; i++) {
        vec2 away = spread * tap(i, way);
        some += texture(shadow_texels, read_at(place, slope, away, layer, border));
        some += texture(shadow_texels, read_at(place, slope, -away, layer, border));
        way = TURN * way;
    }
    bool is_edge = some > 0.0 && some < float(2 * FIRST_PAIRS);
    int pairs = is_edge ? PAIRS : 0;
    way = vec2(1.0, 0.0);
    for (int i = 0; i < pairs; i++) {
        vec2 away = spread * tap(i, way);
        sum += texture(shadow_maps, read_at(place, slope, away, layer, border));
        sum += texture(shadow_maps, read_at(place, slope, -away, layer, border));
        way = TURN * way;
    }
    return is_edge ? sum / float(2 * PAIRS) : some / float(2 * FIRST_PAIRS);
}

// Returns the share of a light, 0 .. 1, that reaches a point of the unit scene. face: geometric normal of the surface;
// to_light: direction to the light; both of unit length.
float lit_share(int light, vec3 point, vec3 face, vec3 to_light)
{
    vec4 how = maps[light];
    if (how.x < 0.0)
        return 1.0;
#ifdef SUN
    const int layer = 0;
#else
    int layer = int(how.x) + (how.y > 1.0 ? cube_face(point - lights[light].position.xyz) : 0);
#endif
    mat4 map = map_from_unit[layer];
    float distance = IS_LAMP(light) ? (map * vec4(point, 1.0)).w : 1.0;
    float texel = shadow_edge.y * distance / min(how.z, how.w), radius = max(shadow_edge.x, texel);
    float facing = abs(dot(face, to_light));
    face = normalize((dot(face, to_light) < 0.0 ? -face : face) + max(0.02 - facing, 0.0) * to_light);
    float lift = 0.2 * radius + texel * (1.0 + 1.0 / max(facing, 0.02)); // depth varies within a texel
    vec4 at = map * vec4(point + lift * to_light, 1.0);
    vec2 slope = depth_slope(map, at, face), spread = radius * how.zw / at.w;
    // Beyond the sides of a cube's map there is the next one: what is lit there is not known.
    float border = how.y > 1.0 ? 0.5 * shadow_edge.y : -1.0;
    return share_around(at.xyz / at.w, slope, spread, float(layer), border);
}
#else
float lit_share(int light, vec3 point, vec3 face, vec3 to_light)
{
    return 1.0;
}
#endif
