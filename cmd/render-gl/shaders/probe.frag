// Amounts of both inks, level of detail, and 1 where something is drawn.
#include "frame.glsl"

in vec2 v_texcoord;
in vec2 v_amounts;
layout(binding = 0) uniform sampler2DArray columns;
out vec4 o_probe;

void main()
{
    o_probe = vec4(v_amounts, textureQueryLod(columns, v_texcoord).y, 1.0);
}
