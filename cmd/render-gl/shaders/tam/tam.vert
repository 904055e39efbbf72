// Single-pass 6-way blend (Real-Time Hatching, section 5): computes the weights of six columns at each vertex, or
// passes on the light if the tone is known only at fragments (tones/ramp.glsl).
#include "tones/ramp.glsl"
#include "frame/lit.glsl"

out vec2 v_texcoord;
#ifdef WEIGHTS_AT_VERTICES
out vec3 v_dark_first, v_dark_second;
#ifdef TWO_INKS
out vec3 v_light_first, v_light_second;
#endif
#endif

void show_vertex()
{
    v_texcoord = hatch_texcoord();
    show_lit();
#ifdef WEIGHTS_AT_VERTICES
    column_weights(v_amounts.x, v_dark_first, v_dark_second);
#ifdef TWO_INKS
    column_weights(v_amounts.y, v_light_first, v_light_second);
#endif
#endif
}

#ifdef PIECES
void main()
{
    vec2 texcoord = vec2(0.0);
#ifdef WEIGHTS_AT_VERTICES
    vec3 weights[4] = vec3[4](vec3(0.0), vec3(0.0), vec3(0.0), vec3(0.0));
#endif
    for (int k = 0; k < 3; k++) {
        take_corner(k);
        show_vertex();
        add_lit(a_weight[k]);
        texcoord += a_weight[k] * v_texcoord;
#ifdef WEIGHTS_AT_VERTICES
        weights[0] += a_weight[k] * v_dark_first;
        weights[1] += a_weight[k] * v_dark_second;
#ifdef TWO_INKS
        weights[2] += a_weight[k] * v_light_first;
        weights[3] += a_weight[k] * v_light_second;
#endif
#endif
    }
    set_lit();
    v_texcoord = texcoord;
#ifdef WEIGHTS_AT_VERTICES
    v_dark_first = weights[0];
    v_dark_second = weights[1];
#ifdef TWO_INKS
    v_light_first = weights[2];
    v_light_second = weights[3];
#endif
#endif
}
#else
void main()
{
    show_vertex();
}
#endif
