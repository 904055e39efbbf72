// Passes on the tone and, with STROKES, the texture coordinates that strokes follow.
#include "frame/lit.glsl"

#ifdef STROKES
out vec2 v_texcoord;
#endif

void main()
{
#ifdef STROKES
    v_texcoord = hatch_texcoord();
#endif
    show_lit();
}
