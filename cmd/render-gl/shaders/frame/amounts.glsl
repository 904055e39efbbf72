// Defines amounts(), which returns the amount of each ink at a fragment. Light is computed at the vertices or, with
// PIXEL_LIGHT, at the fragment. With WEIGHTS_AT_VERTICES the vertex stage passes on weights of columns instead, and
// amounts() is not defined.
#include "frame/light.glsl"
#include "frame/base.glsl"

#ifdef PIXEL_LIGHT
in vec3 v_point, v_normal;

// Returns the geometric normal of the face, or the given normal if the face is too small for floats.
vec3 face_normal(vec3 normal)
{
    vec3 face = cross(dFdx(v_point), dFdy(v_point));
    float size = length(face);
    return size > 1e-12 ? face / size : normal;
}

#ifdef NORMAL_MAP
layout(binding = UNIT_NORMALS) uniform sampler2D normal_map;
layout(location = UNIFORM_NORMAL_STRENGTH) uniform float normal_strength;
in vec4 v_tangent;
in vec2 v_normal_texcoord;

// Returns the normal of the normal map, on the side of the face that is drawn. As in MikkTSpace, the interpolated
// tangent frame is not normalised.
vec3 shading_normal()
{
    vec3 tilt = texture(normal_map, v_normal_texcoord).xyz * 2.0 - 1.0, up = side * v_normal;
    tilt.xy -= clamp(tilt.xy, -1.0 / 255.0, 1.0 / 255.0); // 8 bits cannot encode 0, so 127 and 128 both count as 0
    tilt.xy *= normal_strength;
    vec3 normal = tilt.x * v_tangent.xyz + tilt.y * v_tangent.w * cross(up, v_tangent.xyz) + tilt.z * up;
    return side * normal / max(length(normal), 1e-20);
}
#else
vec3 shading_normal()
{
    return v_normal / max(length(v_normal), 1e-20);
}
#endif

vec2 amounts()
{
    vec3 normal = shading_normal();
    return ink_amounts(light_at(v_point, normal, face_normal(normal)) * base.x * base_light());
}
#elif defined(BASE_TONE)
in float v_light;

vec2 amounts()
{
    return ink_amounts(v_light * base_light());
}
#elif !defined(WEIGHTS_AT_VERTICES)
in vec2 v_amounts;

vec2 amounts()
{
    return v_amounts;
}
#endif
