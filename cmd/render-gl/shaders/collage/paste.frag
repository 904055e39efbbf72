// Last pass of the collage: strips of paper with white borders.
#include "frame/frame.glsl"

layout(binding = UNIT_SOURCE) uniform sampler2D papers; // of pixels
layout(binding = UNIT_TECHNIQUE + 1) uniform sampler2D away; // likewise
layout(binding = UNIT_TECHNIQUE + 2) uniform sampler2D strips;
layout(binding = UNIT_TECHNIQUE + 4) uniform sampler2D depths;
layout(location = UNIFORM_C) uniform int pixel_side; // samples along it
out vec4 o_color;

// Returns the paper of a pixel or, where an item covers samples but not the middle of the pixel, of the next.
vec3 paper_at(ivec2 pixel)
{
    ivec2 last = textureSize(papers, 0) - 1;
    vec4 sum = texelFetch(papers, pixel, 0);
    for (int i = 0; i < 9 && sum.a == 0.0; i++)
        sum = texelFetch(papers, clamp(pixel + ivec2(i % 3 - 1, i / 3 - 1), ivec2(0), last), 0);
    return sum.rgb;
}

void main()
{
    ivec2 here = ivec2(gl_FragCoord.xy), pixel = here / pixel_side;
    if (texelFetch(strips, here, 0).x == 0.0)
        discard;
    vec4 own = texelFetch(away, pixel, 0);
    float white = own.x == 0.0 ? min(own.w, 1.0) : clamp(own.w - own.y + 0.5, 0.0, min(own.w, 1.0));
    o_color = vec4(mix(paper_at(pixel), vec3(max(max(paper.r, paper.g), max(paper.b, 0.9))), white), 1.0);
    gl_FragDepth = texelFetch(depths, here, 0).x;
}
