// Place of a fragment in the pattern of seed points, and the derivatives of the screen position along the surface.
in vec2 v_texcoord; // PIECES: from the piece's origin
in vec3 v_along_u, v_along_v;

// The place at a nesting depth: texture coordinates over 2^depth, in tiles. Only the fraction and the two lowest
// integer bits matter, so that pieces leave out multiples of 4, to keep precision.
#ifdef PIECES
flat in uvec4 v_origin_u, v_origin_v;

uint word_of(uvec4 number, int word)
{
    if (word < 0)
        return 0u;
    return word < 4 ? number[word] : (number.w >> 31) * 0xffffffffu;
}

// 32 bits of a fixed-point number of 64.64 bits, divided by 2^depth: two integer bits and thirty of the fraction.
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

// Movement on the screen, in pixels, for a movement by `vector` in the scene. Uses the fragment's position on the
// screen, because floats do not hold its position in the scene precisely enough.
vec2 pixels_along(vec3 vector)
{
    vec2 at = gl_FragCoord.xy / (viewport.xy * sqrt(curve.w)) - 1.0;
    vec4 move = clip_from_unit * vec4(vector, 0.0);
    return viewport.xy * (move.xy - at * move.w) * gl_FragCoord.w;
}

// Movement on the screen for a unit of u and of v, from the differences between neighbouring fragments.
mat2 pixels_by_derivative()
{
    vec2 x = dFdx(v_texcoord), y = dFdy(v_texcoord);
    float area = x.x * y.y - x.y * y.x;
    return mat2(y.y, -x.y, -y.x, x.x) / (area * sqrt(curve.w));
}

// Movement on the screen for a unit of u and of v; by the vertices' surface derivatives if they have any.
mat2 pixels_along_both()
{
    mat2 derived = pixels_by_derivative();
    if (v_along_u == vec3(0.0) || v_along_v == vec3(0.0)) // not by length: squares of small numbers are 0
        return derived;
    return mat2(pixels_along(v_along_u), pixels_along(v_along_v));
}

// Width on the screen, in pixels, of a strip that is one unit wide and runs along the strokes. On slanted surfaces this
// differs from the length on the screen of the direction across the strokes.
float width_across(mat2 pixels, vec2 turn)
{
    vec2 along = pixels * turn;
    return abs(determinant(pixels)) * inversesqrt(dot(along, along));
}
