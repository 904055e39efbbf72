// Passes on the number of the patch and the place in the texture.
#include "frame/vertex.glsl"

layout(location = ATTRIBUTE_CHART) in uint a_chart;
flat out uint v_chart;
out vec2 v_texcoord;
#ifdef BASE_TEXTURE
out vec2 v_base_texcoord;
#endif

void main()
{
    v_chart = a_chart;
    v_texcoord = hatch_texcoord();
#ifdef BASE_TEXTURE
    v_base_texcoord = a_base_texcoord;
#endif
    place_point();
}
