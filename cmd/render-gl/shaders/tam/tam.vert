// Single-pass 6-way blend (Real-Time Hatching, section 5): computes the weights of six columns at each vertex, or
// passes on the light if the tone is known only at fragments (tones/ramp.glsl).
#include "frame/vertex.glsl"
#include "tones/ramp.glsl"

out vec2 v_texcoord;
#ifdef BASE_TEXTURE
out vec2 v_base_texcoord;
#endif
#ifdef WEIGHTS_AT_VERTICES
out vec3 v_dark_first, v_dark_second;
#ifdef TWO_INKS
out vec3 v_light_first, v_light_second;
#endif
#elif defined(BASE_TONE) && !defined(PIXEL_LIGHT)
out float v_light;
#endif

void main()
{
    v_texcoord = hatch_texcoord();
#ifdef BASE_TEXTURE
    v_base_texcoord = a_base_texcoord;
#endif
#ifdef PIXEL_LIGHT
    place_unlit();
#elif defined(BASE_TONE)
    v_light = place();
#else
    vec2 amounts = ink_amounts(place());
    column_weights(amounts.x, v_dark_first, v_dark_second);
#ifdef TWO_INKS
    column_weights(amounts.y, v_light_first, v_light_second);
#endif
#endif
}
