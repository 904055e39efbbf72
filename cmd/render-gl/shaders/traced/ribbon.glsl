// The ribbon of a stroke, and what its fragments get.
#include "frame/frame.glsl"
#include "traced/look.glsl"

layout(location = UNIFORM_INK) uniform int ink_index;
layout(binding = UNIT_TECHNIQUE) uniform samplerBuffer ribbon; // technique/traced/traced.h: TRACED_RIBBON_FLOATS

noperspective out vec3 v_across; // samples from the middle; half the width in samples; ink
noperspective out vec3 v_ends; // pixels from the start and to the end of the stroke; length of its pointed ends
noperspective out vec2 v_wave; // place and level of a zigzag (look.glsl)
flat out vec3 v_color;
#ifdef BRUSH
noperspective out float v_t; // place along the whole stroke, 0 .. 1
flat out uint v_stroke;
#endif
#ifdef MARKS
noperspective out float v_at; // arc length from the start, in gaps of level 0
noperspective out vec4 v_marks; // struct hatch_mark_point of curve/marks.h without it
flat out uint v_stroke;
#endif

vec4 place(int i)
{
    return texelFetch(ribbon, 3 * i);
}

bool is_first(vec4 more)
{
    return (uint(more.y) & 1u) != 0u;
}

bool is_last(vec4 more)
{
    return (uint(more.y) & 2u) != 0u;
}

// Returns the lengths to both ends as if the stroke went on by its own length beyond an end that is not free: strokes
// taper towards free ends alone.
vec2 tapering(uint bits, vec2 ends)
{
    return ends + (ends.x + ends.y) * vec2((bits & 4u) != 0u, (bits & 8u) != 0u);
}

// Places a side of the ribbon.
// here: place and half width; way: direction in the picture; turn: 1 or -1, the side, or 0: the ribbon ends in a point
void put_side(vec4 here, vec2 way, float turn, vec4 more, vec4 marked)
{
    float size = length(way), half_width = pen.z * here.w;
    vec2 across = size > 1e-6 ? vec2(-way.y, way.x) / size : vec2(0.0);
    float reach = turn * (half_width + pen.z * (marked.w + zigzag.x) + 0.5);
    v_across = vec3(reach, max(half_width, 0.0), more.x);
    v_color = ink_index == 0 ? stroke_color(uint(more.y) >> 4, ink.rgb) : light_ink.rgb;
#ifdef FITTED
    float pointed = 1.0;
    v_wave = vec2(marked.y * (zigzag.z > 0.0 ? zigzag.z : 1.0), marked.z);
#else
    float pointed = marked.z;
    v_wave = vec2(more.z, log2(max(marked.x, 1e-20) / max(zigzag.y, 1e-6)));
#endif
    v_ends = vec3(tapering(uint(more.y), more.zw) * marked.x, max(hand.w * pointed, 1e-3));
#ifdef BRUSH
    v_t = marked.y;
    v_stroke = uint(more.y) >> 4;
#endif
#ifdef MARKS
    v_at = more.z;
    v_marks = marked;
    v_stroke = uint(more.y) >> 4;
#endif
    gl_Position = vec4((here.xy + reach / pen.z * across) / viewport.xy - 1.0, here.z, 1.0);
}
