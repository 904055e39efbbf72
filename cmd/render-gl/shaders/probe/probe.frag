// For --probe: writes the amounts of both inks and the mip level as a colour, with alpha 1.
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
