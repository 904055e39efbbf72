// Places the rectangle around a segment and its round ends.
layout(location = UNIFORM_A) uniform vec2 size_px;
layout(location = UNIFORM_B) uniform float width_px;

layout(location = ATTRIBUTE_LINE_ENDS) in vec4 a_ends; // both ends, in pixels
layout(location = ATTRIBUTE_LINE_DEPTH) in vec3 a_depth; // depth at both ends; z: 1: a halo may cover the segment
layout(location = ATTRIBUTE_LINE_BRUSH) in vec4 a_brush; // width, as a share of width_px, and ink at both ends

flat out vec4 v_ends;
flat out vec3 v_depth;
flat out vec4 v_brush;

void main()
{
    vec2 along = a_ends.zw - a_ends.xy;
    float size = length(along);
    along = size > 1e-6 ? along / size : vec2(1.0, 0.0);
    float reach = 0.5 * max(width_px * max(a_brush.x, a_brush.y), 1.0) + 1.0;
    vec2 corner = (gl_VertexID & 1) == 0 ? a_ends.xy - reach * along : a_ends.zw + reach * along;
    corner += ((gl_VertexID & 2) == 0 ? reach : -reach) * vec2(-along.y, along.x);
    v_ends = a_ends;
    v_depth = a_depth;
    v_brush = a_brush;
    gl_Position = vec4(corner / size_px * 2.0 - 1.0, 0.5, 1.0);
}
