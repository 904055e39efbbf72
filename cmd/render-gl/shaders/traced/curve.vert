// Does the same as ribbon.vert for near views, where lines between points would show corners: they follow Catmull-Rom
// splines, cut into shorter lines, one per instance. There are six vertices, two triangles, for each point.
#include "traced/ribbon.glsl"

layout(location = UNIFORM_COUNT) uniform uint parts;

const float LONGEST = 3.0; // tangents, in lengths of the line

// Shortens a tangent: that of a line whose neighbour ends just before the eye is far too long, and the spline would
// leave the surface.
vec3 shortened(vec3 tangent, float longest)
{
    return tangent * min(1.0, longest / max(length(tangent.xy), 1e-20));
}

void main()
{
    int i = gl_VertexID / 6, corner = gl_VertexID - 6 * i;
    corner = corner < 3 ? corner : corner == 3 ? 2 : corner == 4 ? 1 : 3;
    float part = (float(gl_InstanceID) + float(corner >> 1)) / float(parts), rest = 1.0 - part;
    vec4 from = place(i), to = place(i + 1), before = from, after = to;
    vec4 from_more = texelFetch(ribbon, 3 * i + 1), to_more = texelFetch(ribbon, 3 * i + 4);
    vec4 from_marked = texelFetch(ribbon, 3 * i + 2), to_marked = texelFetch(ribbon, 3 * i + 5);
    float arc = to_more.z - from_more.z, arc_before = 0.0, arc_after = 0.0;
    if (!is_first(from_more) && place(i - 1).w >= 0.0) {
        before = place(i - 1);
        arc_before = from_more.z - texelFetch(ribbon, 3 * i - 2).z;
    }
    if (!is_last(to_more) && place(i + 2).w >= 0.0) {
        after = place(i + 2);
        arc_after = texelFetch(ribbon, 3 * i + 7).z - to_more.z;
    }
    if (from.w < 0.0 || to.w < 0.0 || is_last(from_more)) { // there is no line
        gl_Position = vec4(2.0, 2.0, 0.0, 1.0);
        return;
    }
    float longest = LONGEST * length(to.xy - from.xy);
    vec3 start = shortened(arc / max(arc_before + arc, 1e-20) * (to.xyz - before.xyz), longest);
    vec3 end = shortened(arc / max(arc + arc_after, 1e-20) * (after.xyz - from.xyz), longest);
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
