// Passes on the tone and the texture coordinates of the file.
#include "frame/lit.glsl"

out vec2 v_texcoord;

void main()
{
    v_texcoord = a_texcoord;
    show_lit();
}
