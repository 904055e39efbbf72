// How much of each ink a fragment asks for: from its vertices' light, or lit by itself (PIXEL_LIGHT).
#include "light.glsl"
#include "base.glsl"

#ifdef PIXEL_LIGHT
in vec3 v_point, v_normal;
#elif defined(BASE_TONE)
in float v_light;
#else
in vec2 v_amounts;
#endif

vec2 amounts()
{
#ifdef PIXEL_LIGHT
    vec3 normal = v_normal / max(length(v_normal), 1e-20);
    return ink_amounts(light_at(v_point, normal) * base.x * base_light());
#elif defined(BASE_TONE)
    return ink_amounts(v_light * base_light());
#else
    return v_amounts;
#endif
}
