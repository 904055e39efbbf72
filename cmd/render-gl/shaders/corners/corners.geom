// Passes on, for the tones of a face's three vertices, their places among the columns (place_of in tones/targets.glsl),
// and the barycentric coordinates (v_share).
#include "tones/targets.glsl"

layout(triangles) in;
layout(triangle_strip, max_vertices = 3) out;

in vec2 g_texcoord[3];
in vec2 g_amounts[3];
out vec2 v_texcoord;
out vec3 v_share;
flat out vec3 v_dark_place, v_light_place;
#ifdef BASE_TEXTURE
in vec2 g_base_texcoord[3];
out vec2 v_base_texcoord;
#endif

void main()
{
    vec3 dark, light;
    for (int i = 0; i < 3; i++) {
        dark[i] = place_of(g_amounts[i].x);
        light[i] = place_of(g_amounts[i].y);
    }
    for (int i = 0; i < 3; i++) {
        gl_Position = gl_in[i].gl_Position;
        v_texcoord = g_texcoord[i];
        v_share = vec3(equal(ivec3(i), ivec3(0, 1, 2)));
        v_dark_place = dark;
        v_light_place = light;
#ifdef BASE_TEXTURE
        v_base_texcoord = g_base_texcoord[i];
#endif
        EmitVertex();
    }
    EndPrimitive();
}
