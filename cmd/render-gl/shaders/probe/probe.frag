// Writes the amounts of both inks, the mip level, and 1 where the scene is drawn.
#include "tones/tones.glsl"
#include "frame/base.glsl"

in vec2 v_texcoord;
in vec2 v_amounts;
out vec4 o_probe;

void main()
{
    aim(v_texcoord);
    base_holes();
    if (opacity < 0.5)
        discard;
#ifdef ANISOTROPIC
    float column_level = textureQueryLod(columns, v_texcoord).y;
#endif
    o_probe = vec4(v_amounts, column_level, 1.0);
}
