// Vertex stage of techniques whose geometry stage combines the three vertices of a face.
#include "frame/vertex.glsl"

out vec2 g_texcoord;
out vec2 g_amounts;
#ifdef BASE_TEXTURE
out vec2 g_base_texcoord;
#endif

void main()
{
    float light = place();
    g_texcoord = hatch_texcoord();
#ifdef BASE_TEXTURE
    g_base_texcoord = a_base_texcoord;
#endif
#ifdef BASE_TONE
    light *= dot(textureLod(base_texture, a_base_texcoord, base.y).rgb, vec3(0.2126, 0.7152, 0.0722));
#endif
    g_amounts = ink_amounts(light);
}
