// Passes on the position and, with BASE_TEXTURE, where holes are read.
#include "frame/vertex.glsl"

#ifdef BASE_TEXTURE
out vec2 v_base_texcoord;
#endif

void main()
{
#ifdef PIECES
    take_corner(0);
#endif
#ifdef BASE_TEXTURE
    v_base_texcoord = a_base_texcoord;
#endif
    place_point();
}
