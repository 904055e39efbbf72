// Algorithm 2: per layer the nesting depth from how far apart the picture shows what lies across the
// strokes, then the strokes near the place at that depth.
#include "light.glsl"
#include "inks.glsl"
#include "base.glsl"
#include "seeds.glsl"

in vec2 v_texcoord;
in vec3 v_point, v_along_u, v_along_v;
#ifdef BASE_TONE
in float v_light;
#else
in vec2 v_amounts;
#endif
out vec4 o_color;

// How far the picture moves, in pixels, while the surface moves by a vector.
vec2 pixels_along(vec4 clip, vec3 vector)
{
    vec4 move = clip_from_unit * vec4(vector, 0.0);
    return viewport.xy * (move.xy - clip.xy / clip.w * move.w) / clip.w;
}

// The same for a unit of u and of v, where the vertices say nothing: from the neighbouring fragments.
mat2 pixels_by_derivative()
{
    vec2 x = dFdx(v_texcoord), y = dFdy(v_texcoord);
    float area = x.x * y.y - x.y * y.x;
    return mat2(y.y, -x.y, -y.x, x.x) / (area * sqrt(curve.w));
}

vec2 ink_of(mat2 pixels, vec2 amounts)
{
    vec2 left = vec2(1.0);
    for (int layer = 0; layer < layer_count.x; layer++) {
        vec2 turn = layers[layer].turn.xy;
        float across = length(pixels * vec2(-turn.y, turn.x));
        float depth = log2(stroke.w / across), whole = floor(depth);
        if (!(abs(depth) < 60.0)) // no depth is right: the surface is seen edge on, or has no scale
            continue;
        vec2 at = v_texcoord * exp2(-whole);
        left.x *= layer_paper(layer, at, depth - whole, layer_amount(layer, amounts.x));
#ifdef TWO_INKS
        left.y *= layer_paper(layer, at, depth - whole, layer_amount(layer, amounts.y));
#endif
    }
    return 1.0 - left;
}

void main()
{
    base_holes();
    vec4 clip = clip_from_unit * vec4(v_point, 1.0);
    mat2 pixels = mat2(pixels_along(clip, v_along_u), pixels_along(clip, v_along_v));
    mat2 derived = pixels_by_derivative();
    if (dot(v_along_u, v_along_u) * dot(v_along_v, v_along_v) == 0.0)
        pixels = derived;
#ifdef BASE_TONE
    vec2 v_amounts = ink_amounts(v_light * base_light());
#endif
    vec2 ink = ink_of(pixels, v_amounts);
    o_color = vec4(ink_on_paper(ink.xxx, ink.yyy), opacity);
}
