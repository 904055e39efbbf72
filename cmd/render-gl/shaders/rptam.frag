// Algorithm 2: per layer the nesting depth from how far apart the picture shows what lies across the
// strokes, then the strokes near the place at that depth.
#include "light.glsl"
#include "inks.glsl"
#include "base.glsl"
#include "seeds.glsl"
#include "place.glsl"

#ifdef BASE_TONE
in float v_light;
#else
in vec2 v_amounts;
#endif
out vec4 o_color;

vec2 ink_of(mat2 pixels, vec2 amounts)
{
    vec2 left = vec2(1.0);
    for (int layer = 0; layer < layer_count.x; layer++) {
        vec2 turn = layers[layer].turn.xy;
        float across = length(pixels * vec2(-turn.y, turn.x));
        float depth = log2(stroke.w / across), whole = floor(depth);
        if (!(abs(depth) < 60.0)) // no depth is right: the surface is seen edge on, or has no scale
            continue;
        vec2 at = place_at(whole);
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
#ifdef BASE_TONE
    vec2 v_amounts = ink_amounts(v_light * base_light());
#endif
    vec2 ink = ink_of(pixels_along_both(), v_amounts);
    o_color = vec4(ink_on_paper(ink.xxx, ink.yyy), opacity);
}
