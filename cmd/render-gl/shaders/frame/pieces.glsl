// With PIECES, vertices are those of pieces, into which faces near the eye are cut because floats cannot place such
// faces precisely enough (near/near.h). take_corner() reads the attributes of one corner of the uncut face from buffers
// into variables that are named like the usual inputs.
#ifdef PIECES
layout(location = ATTRIBUTE_PLACE) in vec3 a_place;   // in camera space
layout(location = ATTRIBUTE_FROM) in vec3 a_from;    // place in the texture relative to the piece's origin
layout(location = ATTRIBUTE_WEIGHT) in vec3 a_weight;  // barycentric coordinates in the face
layout(location = ATTRIBUTE_CORNER) in uvec3 a_corner; // indices of the face's vertices
layout(location = ATTRIBUTE_ORIGIN_U) in uvec4 a_origin_u; // fixed-point, 64.64 bits, lowest word first
layout(location = ATTRIBUTE_ORIGIN_V) in uvec4 a_origin_v;
layout(location = ATTRIBUTE_ORIGIN_W) in uvec4 a_origin_w;
layout(location = UNIFORM_CLIP_FROM_CAMERA) uniform mat4 clip_from_camera;
layout(location = UNIFORM_PIECES) uniform vec4 has; // 1: spans; 1: repeats; zw: repeat of all vertices without them
layout(binding = UNIT_PIECES) uniform samplerBuffer corner_vertices; // 10 floats each: struct scene_vertex
layout(binding = UNIT_PIECES + 1) uniform samplerBuffer corner_spans; // 6 floats each: derivatives along u and v
layout(binding = UNIT_PIECES + 2) uniform samplerBuffer corner_repeats; // 2 floats each
#ifdef CHARTS
layout(binding = UNIT_CHARTS) uniform usamplerBuffer corner_charts;
uint a_chart;
#endif

vec3 a_position, a_normal, a_along_u, a_along_v;
vec2 a_texcoord, a_base_texcoord, a_repeat;

float corner_float(samplerBuffer from, int at)
{
    return texelFetch(from, at).r;
}

vec2 corner_pair(samplerBuffer from, int at)
{
    return vec2(corner_float(from, at), corner_float(from, at + 1));
}

vec3 corner_vector(samplerBuffer from, int at)
{
    return vec3(corner_pair(from, at), corner_float(from, at + 2));
}

void take_corner(int k)
{
    int vertex = int(a_corner[k]);
    a_position = corner_vector(corner_vertices, 10 * vertex);
    a_normal = corner_vector(corner_vertices, 10 * vertex + 3);
    a_texcoord = corner_pair(corner_vertices, 10 * vertex + 6);
    a_base_texcoord = corner_pair(corner_vertices, 10 * vertex + 8);
    a_along_u = a_along_v = vec3(0.0);
    if (has.x > 0.0) {
        a_along_u = corner_vector(corner_spans, 6 * vertex);
        a_along_v = corner_vector(corner_spans, 6 * vertex + 3);
    }
    a_repeat = has.zw;
    if (has.y > 0.0)
        a_repeat = corner_pair(corner_repeats, 2 * vertex);
#ifdef CHARTS
    a_chart = texelFetch(corner_charts, vertex).r;
#endif
}

// Takes each corner in turn; returns the place in the base texture.
vec2 corner_base()
{
    vec2 base = vec2(0.0);
    for (int k = 0; k < 3; k++) {
        take_corner(k);
        base += a_weight[k] * a_base_texcoord;
    }
    return base;
}
#endif
