// Draws a stroke over the canvas. Its opacity is the share of a sample's width that it covers.
#include "frame/frame.glsl"
#include "traced/look.glsl"
#include "traced/marks.glsl"
#ifdef BRUSH
#include "strokes/brush.glsl"
#endif

noperspective in vec3 v_across;
noperspective in vec3 v_ends;
noperspective in vec2 v_wave;
flat in vec3 v_color;
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

// Returns the distance from a zigzag instead of from the stroke's line, in samples. Its corners are cut off where they
// reach farther than half the width beyond the amplitude.
// part: is multiplied by what is left of the sample
float zigzag_across(float across, float half_width, inout float part)
{
    vec2 beside = zigzag_beside(v_wave.x, v_wave.y);
    float amplitude = zigzag.x * pen.z, slope = amplitude * beside.y * length(vec2(dFdx(v_wave.x), dFdy(v_wave.x)));
    part *= clamp(amplitude + half_width + 0.5 - abs(across), 0.0, 1.0);
    return (across - amplitude * beside.x) * inversesqrt(1.0 + slope * slope);
}

void main()
{
    float taper = clamp(min(v_ends.x, v_ends.y) / min(v_ends.z, 0.3 * (v_ends.x + v_ends.y)), 0.0, 1.0);
    float half_width = v_across.y * taper * (2.0 - taper), across = v_across.x, part = 1.0;
    if (zigzag.x > 0.0)
        across = zigzag_across(across, half_width, part);
#ifdef MARKS
    Spot spot = Spot(v_stroke, v_at, v_marks.x, v_marks.y, across / pen.z, v_ends.x, v_ends.y,
                     (marks.w > 0.0 ? v_across.y : half_width) / pen.z, v_marks.w, pen.z);
    float covered;
    if (marks.w > 0.0) { // strokes pass one another at their ends
        float passing = max(hand.w, marks.z > 0.0 ? PASSING * v_marks.w / marks.z : 0.0);
        covered = dots_cover(marks, spot, v_marks.z * clamp(min(v_ends.x, v_ends.y) / passing, 0.0, 1.0));
    } else
        covered = marks_cover(marks, spot, min(hand.w, 0.3 * marks.x));
    float opacity = covered * v_across.z;
#else
    float opacity = line_cover(half_width, across, 1.0) * v_across.z;
#endif
#ifdef BRUSH
    opacity *= brush_alpha(v_stroke, v_t, across / pen.z, half_width / pen.z);
#endif
    if (matter.y > 0.0)
        opacity *= 1.0 - matter.y * paper_grain(gl_FragCoord.xy / pen.z + viewport.zw);
    o_color = vec4(v_color, opacity * part);
#ifdef FLAT
    gl_FragDepth = opacity * part; // of strokes that cross, the depth test leaves the one that covers more
#endif
}
