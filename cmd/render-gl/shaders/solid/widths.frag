// Finds whether the strip of paper at a sample is too narrow to be cut out, in its row or in its column.
layout(binding = UNIT_SOURCE) uniform sampler2D strips;
layout(location = UNIFORM_B) uniform float width; // of borders, in samples
out vec4 o_width; // number of the strip; width of its border; 1: it is too narrow; width of a border in a narrow one

// Returns the length of the run of samples with a number along an axis, or most if it is longer.
float run(ivec2 here, ivec2 along, float number, int most)
{
    ivec2 last = textureSize(strips, 0) - 1;
    int length = 1;
    for (int way = -1; way <= 1; way += 2)
        for (int i = 1; length < most; i++) {
            ivec2 at = here + way * i * along;
            if (at != clamp(at, ivec2(0), last))
                return float(most); // the strip may go on outside the tile
            if (texelFetch(strips, at, 0).x != number)
                break;
            length++;
        }
    return float(length);
}

void main()
{
    ivec2 here = ivec2(gl_FragCoord.xy);
    vec2 own = texelFetch(strips, here, 0).xy;
    float border = width * max(own.y, 1.0), least = ceil(2.5 * width), length = least;
    if (own.x > 0.0)
        length = min(run(here, ivec2(1, 0), own.x, int(least)), run(here, ivec2(0, 1), own.x, int(least)));
    o_width = vec4(own.x, border, length < least ? 1.0 : 0.0, length / 3.0);
}
