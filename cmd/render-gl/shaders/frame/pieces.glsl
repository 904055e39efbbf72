// PIECES: corners of pieces of faces that floats cannot place (near/near.h). What the face's own corners hold is
// read from the buffers that faces are drawn from, one corner at a time, into the usual inputs' names.
#ifdef PIECES
layout(location = ATTRIBUTE_PLACE) in vec3 a_place;   // in the camera's coordinates
layout(location = ATTRIBUTE_FROM) in vec2 a_from;    // texture coordinates from the piece's origin
layout(location = ATTRIBUTE_WEIGHT) in vec3 a_weight;  // of the face's corners
layout(location = ATTRIBUTE_CORNER) in uvec3 a_corner;
layout(location = ATTRIBUTE_ORIGIN_U) in uvec4 a_origin_u; // 64.64 bits
layout(location = ATTRIBUTE_ORIGIN_V) in uvec4 a_origin_v;
layout(location = UNIFORM_CLIP_FROM_CAMERA) uniform mat4 clip_from_camera;
layout(location = UNIFORM_PIECES) uniform vec4 has; // spans, repeats; the repeat where there are none
layout(binding = UNIT_PIECES) uniform samplerBuffer corner_vertices; // ten floats each
layout(binding = UNIT_PIECES + 1) uniform samplerBuffer corner_spans;    // six
layout(binding = UNIT_PIECES + 2) uniform samplerBuffer corner_repeats;  // two

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
}
#endif
