// What share of a light reaches a point: the mean of comparisons with its map, over a disk on the surface's own
// plane, so that a plane casts no shadow on itself however it is tilted.
#ifdef SHADOWS
#include "shadow_block.glsl"

layout(binding = 13) uniform sampler2DArrayShadow shadow_maps;

// Golden angles, evenly over the unit disk, and opposite ones: half of them lie on either side of any edge through the
// middle. The outermost come first, so that few tell most places.
const int TAPS = 16, FIRST_TAPS = 8;
const vec2 taps[16] = vec2[](
    vec2(0.9682, 0.0000), vec2(-0.9682, 0.0000), vec2(-0.3266, 0.8401), vec2(0.3266, -0.8401),
    vec2(-0.6114, -0.5601), vec2(0.6114, 0.5601), vec2(0.6726, -0.3319), vec2(-0.6726, 0.3319),
    vec2(0.0578, 0.6589), vec2(-0.0578, -0.6589), vec2(-0.5367, -0.1562), vec2(0.5367, 0.1562),
    vec2(0.2635, -0.3436), vec2(-0.2635, 0.3436), vec2(0.1298, 0.2137), vec2(-0.1298, -0.2137));

// The surface's depth in a map, per unit of x and of y there.
vec2 depth_slope(mat4 map, vec4 at, vec3 face)
{
    vec3 along = normalize(cross(face, abs(face.y) < 0.9 ? vec3(0.0, 1.0, 0.0) : vec3(1.0, 0.0, 0.0)));
    vec4 a = map * vec4(along, 0.0), b = map * vec4(cross(face, along), 0.0);
    vec3 place = at.xyz / at.w;
    vec3 x = a.xyz - place * a.w, y = b.xyz - place * b.w;
    float area = x.x * y.y - y.x * x.y;
    return abs(area) > 1e-12 ? vec2(x.z * y.y - y.z * x.y, y.z * x.x - x.z * y.x) / area : vec2(0.0);
}

int cube_face(vec3 away)
{
    vec3 size = abs(away);
    int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
    return 2 * axis + (away[axis] < 0.0 ? 1 : 0);
}

// face: the surface's own normal, to_light: the direction to the light.
float lit_share(int light, vec3 point, vec3 face, vec3 to_light)
{
    vec4 how = maps[light];
    if (how.x < 0.0)
        return 1.0;
    int layer = int(how.x) + (how.y > 1.0 ? cube_face(point - lights[light].position.xyz) : 0);
    mat4 map = map_from_unit[layer];
    float distance = lights[light].position.w > 0.0 ? (map * vec4(point, 1.0)).w : 1.0;
    float texel = shadow_edge.y * distance / min(how.z, how.w), radius = max(shadow_edge.x, texel);
    float facing = abs(dot(face, to_light));
    face = normalize((dot(face, to_light) < 0.0 ? -face : face) + max(0.02 - facing, 0.0) * to_light);
    float lift = 0.2 * radius + texel * (1.0 + 1.0 / max(facing, 0.02)); // a texel holds one depth of a slanted plane
    vec4 at = map * vec4(point + lift * to_light, 1.0);
    vec2 slope = depth_slope(map, at, face), spread = radius * how.zw / at.w;
    vec3 place = at.xyz / at.w;
    float sum = 0.0;
    int i = 0;
    for (; i < TAPS; i++) {
        vec2 away = spread * taps[i];
        float depth = min(place.z + dot(slope, away), 1.0); // where nothing is, maps hold 1
        sum += texture(shadow_maps, vec4(place.xy + away, float(layer), depth));
        if (i == FIRST_TAPS - 1 && (sum <= 0.0 || sum >= float(FIRST_TAPS)))
            break;
    }
    return sum / float(min(i + 1, TAPS));
}
#else
float lit_share(int light, vec3 point, vec3 face, vec3 to_light)
{
    return 1.0;
}
#endif
