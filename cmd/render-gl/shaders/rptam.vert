// Tone, and where the surface goes with a unit of each texture coordinate.
#include "vertex.glsl"

layout(location = 6) in vec3 a_along_u;
layout(location = 7) in vec3 a_along_v;

out vec2 v_texcoord;
out vec3 v_point, v_along_u, v_along_v;
#ifdef BASE_TEXTURE
out vec2 v_base_texcoord;
#endif
#ifdef BASE_TONE
out float v_light;
#else
out vec2 v_amounts;
#endif

void main()
{
    float light = place();
    vec3 u = mat3(unit_from_mesh) * a_along_u / a_repeat.x, v = mat3(unit_from_mesh) * a_along_v / a_repeat.y;
    float square = dot(hatch.xy, hatch.xy);
    v_point = (unit_from_mesh * vec4(a_position, 1.0)).xyz;
    v_texcoord = hatch_texcoord();
    v_along_u = (hatch.x * u - hatch.y * v) / square;
    v_along_v = (hatch.y * u + hatch.x * v) / square;
#ifdef BASE_TEXTURE
    v_base_texcoord = a_base_texcoord;
#endif
#ifdef BASE_TONE
    v_light = light;
#else
    v_amounts = ink_amounts(light);
#endif
}
