// How much of each ink a fragment asks for: from its vertices' light, or lit by itself (PIXEL_LIGHT). With
// WEIGHTS_AT_VERTICES nobody asks.
#include "light.glsl"
#include "base.glsl"

#ifdef PIXEL_LIGHT
in vec3 v_point, v_normal;

// The normal of the face itself; where floats do not tell it, the vertices'.
vec3 face_normal(vec3 normal)
{
    vec3 face = cross(dFdx(v_point), dFdy(v_point));
    float size = length(face);
    return size > 1e-12 ? face / size : normal;
}

vec2 amounts()
{
    vec3 normal = v_normal / max(length(v_normal), 1e-20);
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
