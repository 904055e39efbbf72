// Draws one pass of tam-triple. Pass 0 draws black; passes 1 to 3 each add the share of one vertex of the face.
#include "tones/layers.glsl"
#include "frame/inks.glsl"
#include "frame/base.glsl"

in vec2 v_texcoord;
in vec3 v_share;
flat in vec3 v_dark_place, v_light_place;
out vec4 o_color;

void main()
{
    aim(v_texcoord);
    base_holes();
    int corner = max(pass - 1, 0);
    vec3 light = vec3(0.0);
#ifdef TWO_INKS
    light = blend(v_light_place[corner]);
#endif
    vec3 color = ink_on_paper(blend(v_dark_place[corner]), light);
    o_color = vec4(pass == 0 ? vec3(0.0) : v_share[corner] * color, opacity);
}
