// Inputs of vertex stages, and functions that place and light a vertex.
#include "frame/light.glsl"

#include "frame/pieces.glsl"

#ifndef PIECES
layout(location = ATTRIBUTE_POSITION) in vec3 a_position;
layout(location = ATTRIBUTE_NORMAL) in vec3 a_normal;
layout(location = ATTRIBUTE_TEXCOORD) in vec2 a_texcoord;
layout(location = ATTRIBUTE_BASE_TEXCOORD) in vec2 a_base_texcoord;
layout(location = ATTRIBUTE_REPEAT) in vec2 a_repeat; // tiles of the map per unit of u and of v
#endif

#ifdef NORMAL_MAP
layout(location = ATTRIBUTE_TANGENT) in vec4 a_tangent;
layout(location = ATTRIBUTE_NORMAL_TEXCOORD) in vec2 a_normal_texcoord;
out vec4 v_tangent; // w: handedness, 1 or -1
out vec2 v_normal_texcoord;
#endif

invariant gl_Position;

// Sets gl_Position; returns the point in the unit scene.
vec3 place_point()
{
    vec4 point = unit_from_mesh * vec4(a_position, 1.0);
#ifdef PIECES
    gl_Position = clip_from_camera * vec4(a_place, 1.0);
#else
    gl_Position = clip_from_unit * point;
#endif
    return point.xyz;
}

#ifdef PIXEL_LIGHT
out vec3 v_point, v_normal;

// Sets gl_Position and the outputs for light per pixel.
void place_unlit()
{
    v_point = place_point();
    vec3 normal = normal_from_mesh * a_normal;
    v_normal = side * normal / max(length(normal), 1e-20);
#ifdef NORMAL_MAP
    mat3 turn = mat3(unit_from_mesh);
    vec3 tangent = turn * a_tangent.xyz;
    v_tangent = vec4(tangent / max(length(tangent), 1e-20), determinant(turn) < 0.0 ? -a_tangent.w : a_tangent.w);
    v_normal_texcoord = a_normal_texcoord;
#endif
}
#endif

// Sets gl_Position; returns the light at the vertex times the lightness of the material.
float place()
{
    vec3 point = place_point();
    vec3 normal = normal_from_mesh * a_normal;
    float size = length(normal);
    normal *= side / max(size, 1e-20);
    return light_at(point, normal, normal) * base.x;
}

// Returns the place of the vertex in the map, in tiles, rotated by --hatch-turn and scaled by --hatch-scale.
vec2 hatch_texcoord()
{
    vec2 tiles = a_texcoord * a_repeat;
    return vec2(hatch.x * tiles.x - hatch.y * tiles.y, hatch.y * tiles.x + hatch.x * tiles.y);
}
