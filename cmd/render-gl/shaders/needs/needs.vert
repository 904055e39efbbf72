// Passes on the tone and the place in the map, which without one is that of the texture coordinates.
#include "frame/lit.glsl"

out vec2 v_texcoord;

void main()
{
    v_texcoord = hatch_texcoord();
    show_lit();
}
