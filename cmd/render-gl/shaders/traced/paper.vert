// Passes on the position and, with BASE_TEXTURE, where holes are read.
#include "frame/vertex.glsl"

#ifdef BASE_TEXTURE
out vec2 v_base_texcoord;
#endif

void main()
{
#ifdef PIECES
    vec2 base = corner_base();
#else
    vec2 base = a_base_texcoord;
#endif
#ifdef BASE_TEXTURE
    v_base_texcoord = base;
#endif
    place_point();
}
