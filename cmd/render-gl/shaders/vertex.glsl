// What every vertex stage does: place the vertex, light it.
#include "light.glsl"

layout(location = 0) in vec3 a_position;
layout(location = 1) in vec3 a_normal;
layout(location = 2) in vec2 a_texcoord;
layout(location = 3) in vec2 a_base_texcoord;
layout(location = 4) in vec2 a_repeat; // tiles of the map per unit of u and of v

invariant gl_Position;

// Sets gl_Position; returns the light that the vertex gets.
float place()
{
    vec4 point = unit_from_mesh * vec4(a_position, 1.0);
    vec3 normal = normal_from_mesh * a_normal;
    float size = length(normal);
    gl_Position = clip_from_unit * point;
    return light_at(point.xyz, side * normal / max(size, 1e-20)) * base.x;
}
