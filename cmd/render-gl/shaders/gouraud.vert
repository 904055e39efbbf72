// The tone alone, or with where strokes lie.
#include "vertex.glsl"

#ifdef STROKES
out vec2 v_texcoord;
#endif
#ifdef BASE_TEXTURE
out vec2 v_base_texcoord;
#endif
#ifdef PIXEL_LIGHT
out vec3 v_point, v_normal;
#elif defined(BASE_TONE)
out float v_light;
#else
out vec2 v_amounts;
#endif

void main()
{
#ifdef STROKES
    v_texcoord = hatch_texcoord();
#endif
#ifdef BASE_TEXTURE
    v_base_texcoord = a_base_texcoord;
#endif
#ifdef PIXEL_LIGHT
    v_point = place_point();
    vec3 normal = normal_from_mesh * a_normal;
    v_normal = side * normal / max(length(normal), 1e-20);
#elif defined(BASE_TONE)
    v_light = place();
#else
    v_amounts = ink_amounts(place());
#endif
}
