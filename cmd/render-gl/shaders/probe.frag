// Amounts of both inks, level of detail, and 1 where something is drawn.
#include "columns.glsl"

in vec2 v_texcoord;
in vec2 v_amounts;
out vec4 o_probe;

void main()
{
    aim(v_texcoord);
#ifdef ANISOTROPIC
    column_level = textureQueryLod(columns, v_texcoord).y;
#endif
    o_probe = vec4(v_amounts, column_level, 1.0);
}
