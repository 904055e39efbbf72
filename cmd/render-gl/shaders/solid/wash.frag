// Second pass of the watercolour, for each pixel: flat washes whose borders wobble.
#include "solid/image.glsl"

layout(location = 0) out vec4 o_wash; // amounts of dark and light ink; coverage; wetness, whose steps are darkened
layout(location = 1) out vec4 o_ink;
layout(location = 2) out vec4 o_grain; // as in marks.frag; rank 0.5 where the pixel shows the paper behind the scene

// Returns an amount of ink in soft steps.
float stepped(float amount)
{
    float at = amount * edges.x, whole = floor(at);
    return min((whole + smoothstep(0.3, 0.7, at - whole)) / edges.x, 1.0);
}

void main()
{
    ivec2 first = ivec2(gl_FragCoord.xy) * side_samples();
    vec2 paper_wobble = 0.5 * vec2(paper_height(gl_FragCoord.xy, 0.25), paper_height(gl_FragCoord.xy, 0.75));
    vec4 washes = vec4(0.0), inks = vec4(0.0), grains = vec4(0.0);
    float own = 0.0;
    for (int y = 0; y < side_samples(); y++)
        for (int x = 0; x < side_samples(); x++) {
            ivec2 here = first + ivec2(x, y);
            vec4 texel = texelFetch(grain, here, 0);
            float covered = texelFetch(wash, here, 0).z;
            ivec2 there = inside(vec2(here) + 0.5 + marks.y * (covered > 0.0 ? texel.zw : paper_wobble));
            vec4 at = texelFetch(wash, there, 0);
            washes += at.z * vec4(at.xy, 1.0, 0.0);
            inks += at.z * texelFetch(colors, there, 0);
            grains += covered * texel;
            own += covered;
        }
    vec2 amount = washes.xy / max(washes.z, 1.0);
    amount = mix(vec2(0.25, 0.0), vec2(1.0), vec2(stepped(amount.x), stepped(amount.y))); // a first thin wash
    float coverage = washes.z / curve.w;
    o_wash = vec4(amount, coverage, coverage * (0.35 + 0.65 * max(amount.x, amount.y)));
    o_ink = inks / max(washes.z, 1.0);
    o_grain = own > 0.0 ? grains / own : vec4(0.5 + 0.5 * paper_height(gl_FragCoord.xy, 0.5), 0.0, 0.0, 0.0);
}
