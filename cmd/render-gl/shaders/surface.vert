// Where a surface is, and nothing else.
#include "vertex.glsl"

void main()
{
    place_point();
}
