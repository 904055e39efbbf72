// The single-pass 6-way blend (section 5): the weights of six columns at each vertex.
#include "vertex.glsl"
#include "ramp.glsl"

out vec2 v_texcoord;
#ifdef BASE_TEXTURE
out vec2 v_base_texcoord;
#endif
#ifdef BASE_TONE
out float v_light;
#else
out vec3 v_dark_first, v_dark_second;
#ifdef TWO_INKS
out vec3 v_light_first, v_light_second;
#endif
#endif

void main()
{
    float light = place();
    v_texcoord = hatch_texcoord();
#ifdef BASE_TEXTURE
    v_base_texcoord = a_base_texcoord;
#endif
#ifdef BASE_TONE
    v_light = light;
#else
    vec2 amounts = ink_amounts(light);
    column_weights(amounts.x, v_dark_first, v_dark_second);
#ifdef TWO_INKS
    column_weights(amounts.y, v_light_first, v_light_second);
#endif
#endif
}
