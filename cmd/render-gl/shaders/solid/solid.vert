// Passes on the tone, and the place of the undeformed surface in the solid texture.
#include "frame/lit.glsl"

out vec3 v_place; // in units of struct hatch_item_rest; with PIECES, relative to the piece's origin
#ifdef PIECES
flat out uvec4 v_origin_u, v_origin_v, v_origin_w;

void main()
{
    for (int k = 0; k < 3; k++) {
        take_corner(k);
        show_lit();
        add_lit(a_weight[k]);
    }
    set_lit();
    v_place = a_from;
    v_origin_u = a_origin_u;
    v_origin_v = a_origin_v;
    v_origin_w = a_origin_w;
}
#else
layout(location = ATTRIBUTE_REST) in vec3 a_rest;

void main()
{
    show_lit();
    v_place = rest_axes * a_rest * rest.w + rest.xyz;
}
#endif
