// Outputs of vertex stages whose fragments are lit: the light or the amounts of ink, and the place in the base texture.
#include "frame/vertex.glsl"

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

// Sets gl_Position and these outputs.
void show_lit()
{
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

#ifdef PIECES
// The same outputs as sums over the corners of the uncut face, weighted by barycentric coordinates.
struct Lit {
    vec3 point, normal;
    vec2 tone, base_texcoord;
};

Lit lit = Lit(vec3(0.0), vec3(0.0), vec2(0.0), vec2(0.0));

// Adds the outputs of show_lit().
void add_lit(float weight)
{
#ifdef BASE_TEXTURE
    lit.base_texcoord += weight * v_base_texcoord;
#endif
#ifdef PIXEL_LIGHT
    lit.point += weight * v_point;
    lit.normal += weight * v_normal;
#elif defined(BASE_TONE)
    lit.tone.x += weight * v_light;
#else
    lit.tone += weight * v_amounts;
#endif
}

void set_lit()
{
#ifdef BASE_TEXTURE
    v_base_texcoord = lit.base_texcoord;
#endif
#ifdef PIXEL_LIGHT
    v_point = lit.point;
    v_normal = lit.normal;
#elif defined(BASE_TONE)
    v_light = lit.tone.x;
#else
    v_amounts = lit.tone;
#endif
}
#endif
