// Places and lights the vertices of an item.
#include "frame/light.glsl"

layout(local_size_x = 64) in;
#include "frame/index.glsl"
layout(std430, binding = STORAGE_VERTICES) readonly buffer Vertices { float vertices[]; }; // 10 each
struct Placed {
    vec4 clip;
    vec4 amounts; // of both inks, seen from the front, then seen from behind; with BASE_TONE the light, before .yw
};
layout(std430, binding = STORAGE_PLACED) writeonly buffer PlacedVertices { Placed placed[]; };
layout(location = UNIFORM_COUNT) uniform uint count;

void main()
{
    uint v = index_of();
    if (v >= count)
        return;
    vec3 position = vec3(vertices[10u * v], vertices[10u * v + 1u], vertices[10u * v + 2u]);
    vec3 normal = normal_from_mesh * vec3(vertices[10u * v + 3u], vertices[10u * v + 4u], vertices[10u * v + 5u]);
    vec4 point = unit_from_mesh * vec4(position, 1.0);
    placed[v].clip = clip_from_unit * point;
#ifndef PIXEL_LIGHT
    normal /= max(length(normal), 1e-20);
    float front = light_at(point.xyz, normal, normal) * base.x;
    float behind = 0.0;
    if (side < 0.0)
        behind = light_at(point.xyz, -normal, -normal) * base.x;
#ifdef BASE_TONE
    placed[v].amounts = vec4(front, 0.0, behind, 0.0);
#else
    placed[v].amounts = vec4(ink_amounts(front), ink_amounts(behind));
#endif
#endif
}
