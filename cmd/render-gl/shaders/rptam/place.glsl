// Computes the place of a fragment in the pattern of seed points, and derivatives of the position on the screen along u
// and v of the surface.
in vec2 v_texcoord; // in tiles; with PIECES, relative to the piece's origin
in vec3 v_along_u, v_along_v;

// place_at() returns the place at a nesting depth, in tiles: the texture coordinates divided by 2^depth. Only its
// fraction and its two lowest integer bits matter. In pieces, multiples of 4 tiles are therefore left out of the
// origin, which saves precision.
#ifdef PIECES
#include "frame/fixed.glsl"
flat in uvec4 v_origin_u, v_origin_v;

vec2 place_at(float depth)
{
    vec2 origin = vec2(bits_at(v_origin_u, int(depth)), bits_at(v_origin_v, int(depth)));
    return origin + v_texcoord * exp2(-depth);
}

// Returns the tiles that place_at() leaves out, modulo 2^32.
ivec2 fours_at(int depth)
{
    return ivec2(fours_at(v_origin_u, depth), fours_at(v_origin_v, depth));
}
#else
vec2 place_at(float depth)
{
    return v_texcoord * exp2(-depth);
}

ivec2 fours_at(int depth)
{
    return ivec2(0);
}
#endif

// Returns the movement on the screen, in pixels, for a movement by `vector` in the unit scene. It is computed from the
// fragment's position on the screen, because floats do not hold the position in the scene precisely enough.
vec2 pixels_along(vec3 vector)
{
    vec2 at = gl_FragCoord.xy / (viewport.xy * sqrt(curve.w)) - 1.0;
    vec4 move = clip_from_unit * vec4(vector, 0.0);
    return viewport.xy * (move.xy - at * move.w) * gl_FragCoord.w;
}

// Returns the movement on the screen, in pixels, for one unit of u and one unit of v, as columns, from the differences
// between neighbouring fragments.
mat2 pixels_by_derivative()
{
    vec2 x = dFdx(v_texcoord), y = dFdy(v_texcoord);
    float area = x.x * y.y - x.y * y.x;
    return mat2(y.y, -x.y, -y.x, x.x) / (area * sqrt(curve.w));
}

// Returns the same as pixels_by_derivative(), but computes it from the derivatives of the surface at the vertices if
// there are any.
mat2 pixels_along_both()
{
    mat2 derived = pixels_by_derivative();
    if (v_along_u == vec3(0.0) || v_along_v == vec3(0.0)) // length() would square, which makes small numbers 0
        return derived;
    return mat2(pixels_along(v_along_u), pixels_along(v_along_v));
}

// Returns the width on the screen, in pixels, of a strip that runs along the strokes and is one unit wide. On slanted
// surfaces this differs from the length on the screen of a unit vector across the strokes.
float width_across(mat2 pixels, vec2 turn)
{
    vec2 along = pixels * turn;
    return abs(determinant(pixels)) * inversesqrt(dot(along, along));
}
