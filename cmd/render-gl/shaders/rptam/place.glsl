// Where a fragment lies among the seeds, and how far the picture moves with it.
in vec2 v_texcoord; // PIECES: from the piece's origin
in vec3 v_along_u, v_along_v;

// The place at a nesting depth: texture coordinates over 2^depth, less whole multiples of 4 where that keeps
// digits. Strokes go by the fraction and by the last two bits of the whole number.
#ifdef PIECES
flat in uvec4 v_origin_u, v_origin_v;

uint word_of(uvec4 number, int word)
{
    if (word < 0)
        return 0u;
    return word < 4 ? number[word] : (number.w >> 31) * 0xffffffffu;
}

// Thirty-two bits of a number of 64.64 bits, over 2^depth: two before the point.
float bits_at(uvec4 number, int depth)
{
    int low = depth + 34, word = low >> 5, shift = low & 31;
    uint bits = word_of(number, word) >> shift;
    if (shift > 0)
        bits |= word_of(number, word + 1) << (32 - shift);
    return float(bits) / 1073741824.0;
}

vec2 place_at(float depth)
{
    vec2 origin = vec2(bits_at(v_origin_u, int(depth)), bits_at(v_origin_v, int(depth)));
    return origin + v_texcoord * exp2(-depth);
}
#else
vec2 place_at(float depth)
{
    return v_texcoord * exp2(-depth);
}
#endif

// How far the picture moves, in pixels, while the surface moves by a vector. Of the fragment's own place only
// what the rasteriser knows counts: floats hold no place in the scene so well.
vec2 pixels_along(vec3 vector)
{
    vec2 at = gl_FragCoord.xy / (viewport.xy * sqrt(curve.w)) - 1.0;
    vec4 move = clip_from_unit * vec4(vector, 0.0);
    return viewport.xy * (move.xy - at * move.w) * gl_FragCoord.w;
}

// The same for a unit of u and of v, where the vertices say nothing: from the neighbouring fragments.
mat2 pixels_by_derivative()
{
    vec2 x = dFdx(v_texcoord), y = dFdy(v_texcoord);
    float area = x.x * y.y - x.y * y.x;
    return mat2(y.y, -x.y, -y.x, x.x) / (area * sqrt(curve.w));
}

mat2 pixels_along_both()
{
    mat2 derived = pixels_by_derivative();
    if (v_along_u == vec3(0.0) || v_along_v == vec3(0.0)) // squares of small ones would be 0
        return derived;
    return mat2(pixels_along(v_along_u), pixels_along(v_along_v));
}

// How wide the picture shows a strip that is one unit wide and lies along the strokes. Its picture slants where the
// surface is seen at an angle: the width is not that of the direction across the strokes.
float width_across(mat2 pixels, vec2 turn)
{
    vec2 along = pixels * turn;
    return abs(determinant(pixels)) * inversesqrt(dot(along, along));
}
