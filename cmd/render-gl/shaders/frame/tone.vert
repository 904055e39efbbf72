// Passes on the tone and, with STROKES, the texture coordinates that strokes follow.
#include "frame/lit.glsl"

#ifdef STROKES
out vec2 v_texcoord;
#endif

#ifdef PIECES
void main()
{
    vec2 texcoord = vec2(0.0);
    for (int k = 0; k < 3; k++) {
        take_corner(k);
        show_lit();
        add_lit(a_weight[k]);
        texcoord += a_weight[k] * hatch_texcoord();
    }
    set_lit();
#ifdef STROKES
    v_texcoord = texcoord;
#endif
}
#else
void main()
{
#ifdef STROKES
    v_texcoord = hatch_texcoord();
#endif
    show_lit();
}
#endif
