// Vertex stage of --probe: passes on texture coordinates and the amounts of both inks.
#include "frame/vertex.glsl"

out vec2 v_texcoord;
out vec2 v_amounts;
#ifdef BASE_TEXTURE
out vec2 v_base_texcoord;
#endif

void main()
{
    float light = place();
    v_texcoord = hatch_texcoord();
#ifdef BASE_TEXTURE
    v_base_texcoord = a_base_texcoord;
#endif
    v_amounts = ink_amounts(light);
}
