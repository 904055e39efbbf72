// Passes on the number of the patch and the place in the texture.
#define CHARTS 1
#include "frame/vertex.glsl"

#ifndef PIECES
layout(location = ATTRIBUTE_CHART) in uint a_chart;
#endif
flat out uint v_chart;
out vec2 v_texcoord; // with PIECES, relative to the piece's origin
#ifdef BASE_TEXTURE
out vec2 v_base_texcoord;
#endif

void main()
{
#ifdef PIECES
    vec2 base = corner_base();
    v_texcoord = a_from.xy;
#else
    vec2 base = a_base_texcoord;
    v_texcoord = hatch_texcoord();
#endif
    v_chart = a_chart;
#ifdef BASE_TEXTURE
    v_base_texcoord = base;
#endif
    place_point();
}
