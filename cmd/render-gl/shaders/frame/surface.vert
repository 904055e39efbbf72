// Passes on the position only, for drawing depth and bare paper.
#include "frame/vertex.glsl"

void main()
{
#ifdef PIECES
    take_corner(0);
#endif
    place_point();
}
