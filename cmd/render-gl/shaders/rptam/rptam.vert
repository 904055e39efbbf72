// Passes on the tone, the texture coordinates, and the derivatives of the surface along u and v; with GATHERS, the
// number of the chart, too.
#ifdef GATHERS
#define CHARTS 1
#endif
#include "frame/lit.glsl"

#ifdef PIECES
flat out uvec4 v_origin_u, v_origin_v;
#else
layout(location = ATTRIBUTE_ALONG_U) in vec3 a_along_u;
layout(location = ATTRIBUTE_ALONG_V) in vec3 a_along_v;
#ifdef GATHERS
layout(location = ATTRIBUTE_CHART) in uint a_chart;
#endif
#endif

#ifdef GATHERS
flat out uint v_chart;
#endif
out vec2 v_texcoord;
out vec3 v_along_u, v_along_v;

void show_vertex()
{
    show_lit();
    vec3 u = mat3(unit_from_mesh) * a_along_u / a_repeat.x, v = mat3(unit_from_mesh) * a_along_v / a_repeat.y;
    float square = dot(hatch.xy, hatch.xy);
    v_texcoord = hatch_texcoord();
#ifdef GATHERS
    v_chart = a_chart;
#endif
    v_along_u = (hatch.x * u - hatch.y * v) / square;
    v_along_v = (hatch.y * u + hatch.x * v) / square;
}

#ifdef PIECES
void main()
{
    vec3 along_u = vec3(0.0), along_v = vec3(0.0);
    for (int k = 0; k < 3; k++) {
        take_corner(k);
        show_vertex();
        add_lit(a_weight[k]);
        along_u += a_weight[k] * v_along_u;
        along_v += a_weight[k] * v_along_v;
    }
    set_lit();
    v_along_u = along_u;
    v_along_v = along_v;
    v_texcoord = a_from.xy;
    v_origin_u = a_origin_u;
    v_origin_v = a_origin_v;
}
#else
void main()
{
    show_vertex();
}
#endif
