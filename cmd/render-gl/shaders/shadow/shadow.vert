// Places a surface in a shadow map.
#include "shadow/block.glsl"
#include "frame/vertex.glsl"

layout(location = UNIFORM_LAYER) uniform int layer;

#ifdef BASE_TEXTURE
out vec2 v_base_texcoord;
#endif

void main()
{
    vec4 point = map_from_unit[layer] * (unit_from_mesh * vec4(a_position, 1.0));
    gl_Position = vec4(2.0 * point.xy - point.w, point.zw);
#ifdef BASE_TEXTURE
    v_base_texcoord = a_base_texcoord;
#endif
}
