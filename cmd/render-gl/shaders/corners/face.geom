// Computes one place among the columns for each face (place_of in tones/targets.glsl), from the mean of the tones at
// its vertices.
#include "tones/targets.glsl"

layout(triangles) in;
layout(triangle_strip, max_vertices = 3) out;

in vec2 g_texcoord[3];
in vec2 g_amounts[3];
out vec2 v_texcoord;
flat out vec2 v_place; // x: place for the dark ink, y: for the light ink
#ifdef BASE_TEXTURE
in vec2 g_base_texcoord[3];
out vec2 v_base_texcoord;
#endif

void main()
{
    vec2 amounts = (g_amounts[0] + g_amounts[1] + g_amounts[2]) / 3.0;
    vec2 where = vec2(place_of(amounts.x), place_of(amounts.y));
    for (int i = 0; i < 3; i++) {
        gl_Position = gl_in[i].gl_Position;
        v_texcoord = g_texcoord[i];
        v_place = where;
#ifdef BASE_TEXTURE
        v_base_texcoord = g_base_texcoord[i];
#endif
        EmitVertex();
    }
    EndPrimitive();
}
