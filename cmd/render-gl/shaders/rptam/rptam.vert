// Passes on the tone, the texture coordinates, and the derivatives of the surface along u and v; with GATHERS, the
// number of the chart, too.
#include "frame/vertex.glsl"

#ifdef PIECES
flat out uvec4 v_origin_u, v_origin_v;
#else
layout(location = ATTRIBUTE_ALONG_U) in vec3 a_along_u;
layout(location = ATTRIBUTE_ALONG_V) in vec3 a_along_v;
#endif

#ifdef GATHERS
layout(location = ATTRIBUTE_CHART) in uint a_chart;
flat out uint v_chart;
#endif
out vec2 v_texcoord;
out vec3 v_along_u, v_along_v;
#ifdef BASE_TEXTURE
out vec2 v_base_texcoord;
#endif
#ifndef PIXEL_LIGHT
#ifdef BASE_TONE
out float v_light;
#else
out vec2 v_amounts;
#endif
#endif

void show_vertex()
{
#ifdef PIXEL_LIGHT
    place_unlit();
#elif defined(BASE_TONE)
    v_light = place();
#else
    v_amounts = ink_amounts(place());
#endif
    vec3 u = mat3(unit_from_mesh) * a_along_u / a_repeat.x, v = mat3(unit_from_mesh) * a_along_v / a_repeat.y;
    float square = dot(hatch.xy, hatch.xy);
    v_texcoord = hatch_texcoord();
#ifdef GATHERS
    v_chart = a_chart;
#endif
    v_along_u = (hatch.x * u - hatch.y * v) / square;
    v_along_v = (hatch.y * u + hatch.x * v) / square;
#ifdef BASE_TEXTURE
    v_base_texcoord = a_base_texcoord;
#endif
}

#ifdef PIECES
// The outputs for one corner of the face, times the corner's weight.
struct Share {
    vec3 along_u, along_v, point, normal;
    vec2 tone, base_texcoord;
};

Share share_of(int k)
{
    Share share = Share(vec3(0.0), vec3(0.0), vec3(0.0), vec3(0.0), vec2(0.0), vec2(0.0));
    take_corner(k);
    show_vertex();
    share.along_u = a_weight[k] * v_along_u;
    share.along_v = a_weight[k] * v_along_v;
#ifdef BASE_TEXTURE
    share.base_texcoord = a_weight[k] * v_base_texcoord;
#endif
#ifdef PIXEL_LIGHT
    share.point = a_weight[k] * v_point;
    share.normal = a_weight[k] * v_normal;
#elif defined(BASE_TONE)
    share.tone.x = a_weight[k] * v_light;
#else
    share.tone = a_weight[k] * v_amounts;
#endif
    return share;
}

void main()
{
    Share a = share_of(0), b = share_of(1), c = share_of(2);
    v_along_u = a.along_u + b.along_u + c.along_u;
    v_along_v = a.along_v + b.along_v + c.along_v;
#ifdef BASE_TEXTURE
    v_base_texcoord = a.base_texcoord + b.base_texcoord + c.base_texcoord;
#endif
#ifdef PIXEL_LIGHT
    v_point = a.point + b.point + c.point;
    v_normal = a.normal + b.normal + c.normal;
#elif defined(BASE_TONE)
    v_light = a.tone.x + b.tone.x + c.tone.x;
#else
    v_amounts = a.tone + b.tone + c.tone;
#endif
    v_texcoord = a_from;
    v_origin_u = a_origin_u;
    v_origin_v = a_origin_v;
}
#else
void main()
{
    show_vertex();
}
#endif
