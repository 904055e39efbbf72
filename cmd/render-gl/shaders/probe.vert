// What a picture asks of the map: for probe.frag.
#include "vertex.glsl"

out vec2 v_texcoord;
out vec2 v_amounts;

void main()
{
    float light = place();
    v_texcoord = a_texcoord * a_repeat;
    v_amounts = ink_amounts(light);
}
