// Places a mark: a short line of fixed width on the screen, slightly in front of a surface.
#include "frame/frame.glsl"

layout(location = UNIFORM_MARK_WIDTH) uniform vec2 half_width; // in normalised device coordinates

layout(location = ATTRIBUTE_MARK_MIDDLE) in vec3 a_middle;
layout(location = ATTRIBUTE_MARK_HALF) in vec3 a_half; // vector from the middle to an end
layout(location = ATTRIBUTE_MARK_CONFIDENCE) in float a_confidence;

flat out float v_confidence;

void main()
{
    vec3 to_eye = normalize(eye.xyz - eye.w * a_middle);
    vec3 middle = a_middle + 0.4 * length(a_half) * to_eye;
    vec4 a = clip_from_unit * vec4(middle - a_half, 1.0), b = clip_from_unit * vec4(middle + a_half, 1.0);
    vec2 along = (b.xy / b.w - a.xy / a.w) / half_width;
    float size = length(along);
    vec2 across = size > 1e-6 ? vec2(-along.y, along.x) / size : vec2(0.0, 1.0);
    gl_Position = (gl_VertexID & 1) == 0 ? a : b;
    gl_Position.xy += ((gl_VertexID & 2) == 0 ? 1.0 : -1.0) * across * half_width * gl_Position.w;
    if (min(a.w, b.w) <= 0.0)
        gl_Position = vec4(0.0, 0.0, -1.0, 1.0); // behind the camera: clipped
    v_confidence = a_confidence;
}
