// Where a surface is, and nothing else.
#include "frame/vertex.glsl"

void main()
{
#ifdef PIECES
    take_corner(0);
#endif
    place_point();
}
