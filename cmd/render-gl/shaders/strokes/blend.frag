// Terms of a stroke's sums, which blending adds up (Szecsi et al., Tonal Art Maps with Image Space Strokes, 2.2), each
// times what the fragment counts.
// technique/strokes/blend.c has the formats.
#include "frame/frame.glsl"
#include "strokes/curve.glsl"

flat in uvec4 v_fragment;
layout(location = 0) out vec4 o_powers;  // 1, t, t^2, t^3, with t from -1 to 1 along the whole stroke
layout(location = 1) out vec4 o_higher;  // t^4, t^5, t^6; share of the pixel that is covered
layout(location = 2) out vec4 o_x;       // x, x t, x t^2, x t^3, from the middle of the picture
layout(location = 3) out vec4 o_y;
layout(location = 4) out vec4 o_extremes; // largest of -t, t, and of minus and plus a hash of the id
layout(location = 5) out uvec2 o_id;

void main()
{
    float t = 2.0 * t_of(v_fragment.zw) - 1.0, square = t * t, hash = float(v_fragment.x >> 8);
    float share = share_of(v_fragment.zw, SHARE_BITS);
    vec2 place = pixel_of(v_fragment.zw) - viewport.xy;
    o_powers = share * vec4(1.0, t, square, square * t);
    o_higher = vec4(share * square * square * vec3(1.0, t, square), float(v_fragment.w >> 16) / 65535.0);
    o_x = place.x * o_powers;
    o_y = place.y * o_powers;
    o_extremes = vec4(-t, t, -hash, hash);
    o_id = v_fragment.xy;
}
