// Does the same as ribbon.vert for near views, where lines between points would show corners: they follow Catmull-Rom
// splines, cut into shorter lines, one per instance. There are six vertices, two triangles, for each point.
#include "traced/ribbon.glsl"

layout(location = UNIFORM_COUNT) uniform uint parts;

void main()
{
    int i = gl_VertexID / 6, corner = gl_VertexID - 6 * i;
    corner = corner < 3 ? corner : corner == 3 ? 2 : corner == 4 ? 1 : 3;
    float part = (float(gl_InstanceID) + float(corner >> 1)) / float(parts), rest = 1.0 - part;
    vec4 from = place(i), to = place(i + 1), before = from, after = to;
    vec4 from_more = texelFetch(ribbon, 3 * i + 1), to_more = texelFetch(ribbon, 3 * i + 4);
    vec4 from_marked = texelFetch(ribbon, 3 * i + 2), to_marked = texelFetch(ribbon, 3 * i + 5);
    float length = to_more.z - from_more.z, length_before = 0.0, length_after = 0.0;
    if (!is_first(from_more) && place(i - 1).w >= 0.0) {
        before = place(i - 1);
        length_before = from_more.z - texelFetch(ribbon, 3 * i - 2).z;
    }
    if (!is_last(to_more) && place(i + 2).w >= 0.0) {
        after = place(i + 2);
        length_after = texelFetch(ribbon, 3 * i + 7).z - to_more.z;
    }
    if (from.w < 0.0 || to.w < 0.0 || is_last(from_more)) { // there is no line
        gl_Position = vec4(2.0, 2.0, 0.0, 1.0);
        return;
    }
    vec3 start = length / max(length_before + length, 1e-20) * (to.xyz - before.xyz);
    vec3 end = length / max(length + length_after, 1e-20) * (after.xyz - from.xyz);
    vec3 here = rest * rest * ((1.0 + 2.0 * part) * from.xyz + part * start) +
                part * part * ((1.0 + 2.0 * rest) * to.xyz - rest * end);
    here.z = max(here.z, mix(from.z, to.z, part)); // where faces meet in a hollow, splines pass under them
    vec2 way = 6.0 * part * rest * (to.xy - from.xy) + rest * (1.0 - 3.0 * part) * start.xy +
               part * (1.0 - 3.0 * rest) * end.xy;
    vec4 more = mix(from_more, to_more, part);
    more.y = from_more.y;
    float turn = max(from.w, to.w) <= 0.0 ? 0.0 : (corner & 1) == 0 ? 1.0 : -1.0;
    put_side(vec4(here, mix(from.w, to.w, part)), way, turn, more, mix(from_marked, to_marked, part));
}
