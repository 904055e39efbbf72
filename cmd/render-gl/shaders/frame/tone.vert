// Passes on the tone and, with STROKES, the texture coordinates that strokes follow.
#include "frame/vertex.glsl"

#ifdef STROKES
out vec2 v_texcoord;
#endif
#ifdef BASE_TEXTURE
out vec2 v_base_texcoord;
#endif
#ifndef PIXEL_LIGHT
#ifdef BASE_TONE
out float v_light;
#else
out vec2 v_amounts;
#endif
#endif

void main()
{
#ifdef STROKES
    v_texcoord = hatch_texcoord();
#endif
#ifdef BASE_TEXTURE
    v_base_texcoord = a_base_texcoord;
#endif
#ifdef PIXEL_LIGHT
    place_unlit();
#elif defined(BASE_TONE)
    v_light = place();
#else
    v_amounts = ink_amounts(place());
#endif
}
