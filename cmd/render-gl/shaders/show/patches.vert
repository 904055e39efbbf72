// Passes on the light, and the tone of the patch (0 for surfaces without patches).
#include "frame/vertex.glsl"

#ifdef OUTLINE
layout(location = ATTRIBUTE_PATCH) in float a_patch_tone;
#endif

#ifdef BASE_TEXTURE
out vec2 v_base_texcoord;
#endif
out float v_lightness;
flat out float v_tone;

void main()
{
    v_lightness = clamp(place(), 0.0, 1.0);
#ifdef BASE_TEXTURE
    v_base_texcoord = a_base_texcoord;
#endif
#ifdef OUTLINE
    v_tone = a_patch_tone;
#else
    v_tone = 0.0;
#endif
}
