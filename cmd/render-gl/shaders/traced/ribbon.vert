// Places the two sides of the ribbon at a point of a stroke.
#include "frame/frame.glsl"
#include "traced/style.glsl"

layout(binding = UNIT_TECHNIQUE) uniform samplerBuffer ribbon; // as points.comp writes it

noperspective out vec3 v_across; // samples from the middle; half the width in samples; ink
noperspective out vec2 v_ends; // pixels from the start and to the end of the stroke

vec4 place(int i)
{
    return texelFetch(ribbon, 2 * clamp(i, 0, textureSize(ribbon) / 2 - 1));
}

void main()
{
    int i = gl_VertexID >> 1;
    vec4 here = place(i), before = place(i - 1), after = place(i + 1);
    vec4 more = texelFetch(ribbon, 2 * i + 1);
    int ends = int(more.y);
    v_ends = more.zw;
    if ((ends & 1) != 0 || before.w < 0.0)
        before = here;
    if ((ends & 2) != 0 || after.w < 0.0)
        after = here;
    vec2 way = after.xy - before.xy;
    float size = length(way), half_width = pen.z * here.w;
    vec2 across = size > 1e-6 ? vec2(-way.y, way.x) / size : vec2(0.0);
    float reach = half_width > 0.0 ? half_width + 0.5 : 0.0, turn = (gl_VertexID & 1) == 0 ? 1.0 : -1.0;
    v_across = vec3(turn * reach, max(half_width, 0.0), more.x);
    gl_Position = vec4((here.xy + turn * reach / pen.z * across) / viewport.xy - 1.0, here.z, 1.0);
}
