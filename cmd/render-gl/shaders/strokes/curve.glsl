// A cubic over a range of t, and the words of a fragment that lies on it (z and w of fragments.glsl).
struct Cubic {
    vec2 range;  // of t
    vec2 origin; // in pixels
    vec4 x, y;   // factors of Legendre polynomials 0 to 3 of u, which runs from -1 to 1 over the range
    float weight;
};

float t_of(uvec2 fragment)
{
    return float(fragment.y & 0xffffu) / 65535.0;
}

const int SHARE_BITS = 15; // at most

// Returns what the fragment counts: the share of the pixel that is covered, the middle of 2^(1 - bits).
float share_of(uvec2 fragment, int bits)
{
    return ldexp(float(2u * (fragment.y >> (33 - bits)) + 1u), -bits);
}

vec2 pixel_of(uvec2 fragment)
{
    return vec2(fragment.x & 0xffffu, fragment.x >> 16) + 0.5;
}

float u_of(Cubic cubic, float t)
{
    float half_range = 0.5 * (cubic.range.y - cubic.range.x);
    return half_range > 0.0 ? (t - cubic.range.x) / half_range - 1.0 : 0.0;
}

// Returns the place at u, in pixels; beyond -1 and 1 along the tangents.
vec2 place_on(Cubic cubic, float u)
{
    float inside = clamp(u, -1.0, 1.0), square = inside * inside;
    vec4 values = vec4(1.0, inside, 1.5 * square - 0.5, (2.5 * square - 1.5) * inside);
    values += (u - inside) * vec4(0.0, 1.0, 3.0 * inside, 7.5 * square - 1.5);
    return cubic.origin + vec2(dot(cubic.x, values), dot(cubic.y, values));
}
