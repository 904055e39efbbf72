// Draws a stroke over the canvas. Its opacity is the share of a sample's width that it covers.
#include "frame/frame.glsl"
#include "traced/style.glsl"
#include "traced/marks.glsl"
#ifdef BRUSH
#include "strokes/brush.glsl"
#endif

layout(location = UNIFORM_INK) uniform int ink_index;
noperspective in vec3 v_across;
noperspective in vec2 v_ends;
#ifdef BRUSH
noperspective in float v_t;
flat in uint v_stroke;
#endif
#ifdef MARKS
noperspective in float v_at;
noperspective in vec4 v_marks;
flat in uint v_stroke;
#endif
out vec4 o_color;

void main()
{
    float taper = clamp(min(v_ends.x, v_ends.y) / min(hand.w, 0.3 * (v_ends.x + v_ends.y)), 0.0, 1.0);
    float half_width = v_across.y * taper * (2.0 - taper);
#ifdef MARKS
    Spot spot = Spot(v_stroke, v_at, v_marks.x, v_marks.y, v_across.x / pen.z, v_ends.x, v_ends.y,
                     (marks.w > 0.0 ? v_across.y : half_width) / pen.z, v_marks.w, pen.z);
    float covered;
    if (marks.w > 0.0) { // strokes pass one another at their ends
        float passing = max(hand.w, marks.z > 0.0 ? PASSING * v_marks.w / marks.z : 0.0);
        covered = dots_cover(marks, spot, v_marks.z * clamp(min(v_ends.x, v_ends.y) / passing, 0.0, 1.0));
    } else
        covered = marks_cover(marks, spot, min(hand.w, 0.3 * marks.x));
    float opacity = covered * v_across.z;
#else
    float opacity = line_cover(half_width, v_across.x, 1.0) * v_across.z;
#endif
#ifdef BRUSH
    opacity *= brush_alpha(v_stroke, v_t, v_across.x / pen.z, half_width / pen.z);
#endif
    if (matter.y > 0.0)
        opacity *= 1.0 - matter.y * paper_grain(gl_FragCoord.xy / pen.z + viewport.zw);
    o_color = vec4(ink_index == 0 ? ink.rgb : light_ink.rgb, opacity);
}
