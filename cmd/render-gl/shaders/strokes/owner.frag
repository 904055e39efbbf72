// Writes which patch lies on top, its number plus 2; its depth; and the direction of u in the picture, with twice its
// angle. Other surfaces write 0, and paper below patches a number of at most 1.
#include "frame/frame.glsl"
#include "frame/base.glsl"
#include "strokes/doubled.glsl"

flat in uint v_chart;
in vec2 v_texcoord;
out vec4 o_owner;

void main()
{
    vec2 along = vec2(dFdy(v_texcoord.y), -dFdx(v_texcoord.y));
    base_holes();
#ifdef OUTLINE
    if (opacity < 0.5)
        discard;
    o_owner = vec4(float(v_chart + 2u), gl_FragCoord.z, doubled(along));
#else
    o_owner = vec4(0.0);
#endif
}
