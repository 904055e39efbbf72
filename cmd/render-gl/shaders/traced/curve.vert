// Does the same as ribbon.vert for near views, where lines between points would show corners: they follow Catmull-Rom
// splines, by lengths in the picture, cut into shorter lines, one per instance. There are six vertices, two triangles,
// for each point.
#include "frame/frame.glsl"
#include "traced/style.glsl"

layout(binding = UNIT_TECHNIQUE) uniform samplerBuffer ribbon; // as points.comp writes it
layout(location = UNIFORM_COUNT) uniform uint parts;

noperspective out vec3 v_across; // samples from the middle; half the width in samples; ink
noperspective out vec2 v_ends; // pixels from the start and to the end of the stroke

void main()
{
    int i = gl_VertexID / 6, corner = gl_VertexID - 6 * i;
    corner = corner < 3 ? corner : corner == 3 ? 2 : corner == 4 ? 1 : 3;
    float part = (float(gl_InstanceID) + float(corner >> 1)) / float(parts), rest = 1.0 - part;
    vec4 from = texelFetch(ribbon, 2 * i), to = texelFetch(ribbon, 2 * i + 2), before = from, after = to;
    vec4 from_more = texelFetch(ribbon, 2 * i + 1), to_more = texelFetch(ribbon, 2 * i + 3);
    if ((int(from_more.y) & 1) == 0)
        before = texelFetch(ribbon, 2 * i - 2);
    if ((int(to_more.y) & 2) == 0)
        after = texelFetch(ribbon, 2 * i + 4);
    if (from.w < 0.0 || to.w < 0.0 || (int(from_more.y) & 2) != 0) { // there is no line
        gl_Position = vec4(2.0, 2.0, 0.0, 1.0);
        return;
    }
    before = before.w < 0.0 ? from : before;
    after = after.w < 0.0 ? to : after;
    float size_px = max(distance(from.xy, to.xy), 1e-6); // points may be at any distance from one another
    vec3 start = (to.xyz - before.xyz) * size_px / (size_px + distance(before.xy, from.xy));
    vec3 end = (after.xyz - from.xyz) * size_px / (size_px + distance(to.xy, after.xy));
    vec3 here = rest * rest * ((1.0 + 2.0 * part) * from.xyz + part * start) +
                part * part * ((1.0 + 2.0 * rest) * to.xyz - rest * end);
    vec2 way = 6.0 * part * rest * (to.xy - from.xy) + rest * (1.0 - 3.0 * part) * start.xy +
               part * (1.0 - 3.0 * rest) * end.xy;
    float size = length(way), half_width = pen.z * mix(from.w, to.w, part);
    vec2 across = size > 1e-6 ? vec2(-way.y, way.x) / size : vec2(0.0);
    float reach = max(from.w, to.w) > 0.0 ? half_width + 0.5 : 0.0, turn = (corner & 1) == 0 ? 1.0 : -1.0;
    v_ends = mix(from_more.zw, to_more.zw, part);
    v_across = vec3(turn * reach, half_width, mix(from_more.x, to_more.x, part));
    gl_Position = vec4((here.xy + turn * reach / pen.z * across) / viewport.xy - 1.0, here.z, 1.0);
}
