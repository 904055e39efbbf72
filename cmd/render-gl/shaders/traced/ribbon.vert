// Places the two sides of the ribbon at a point of a stroke.
#include "traced/ribbon.glsl"

void main()
{
    int i = gl_VertexID >> 1, last = textureSize(ribbon) / 3 - 1;
    vec4 here = place(i), before = place(max(i - 1, 0)), after = place(min(i + 1, last));
    vec4 more = texelFetch(ribbon, 3 * i + 1), marked = texelFetch(ribbon, 3 * i + 2);
    bool nowhere = here.w < 0.0; // too near the eye or behind it: the ribbon ends at the point beside
    if (nowhere)
        here = !is_first(more) && before.w >= 0.0 ? before : !is_last(more) && after.w >= 0.0 ? after : here;
    if (is_first(more) || before.w < 0.0)
        before = here;
    if (is_last(more) || after.w < 0.0)
        after = here;
    float turn = nowhere || here.w <= 0.0 ? 0.0 : (gl_VertexID & 1) == 0 ? 1.0 : -1.0;
    put_side(here, after.xy - before.xy, turn, more, marked);
}
