// Second pass of the watercolour: flat washes whose borders wobble.
#include "solid/image.glsl"

layout(location = 0) out vec4 o_wash; // amounts of dark and light ink; coverage; wetness, whose steps are darkened

layout(location = 1) out vec4 o_ink;

// Returns an amount of ink in soft steps.
float stepped(float amount)
{
    float at = amount * edges.x, whole = floor(at);
    return min((whole + smoothstep(0.3, 0.7, at - whole)) / edges.x, 1.0);
}

void main()
{
    ivec2 here = ivec2(gl_FragCoord.xy);
    vec2 wobble = texelFetch(grain, here, 0).zw;
    if (texelFetch(wash, here, 0).z == 0.0)
        wobble = 0.5 * vec2(paper_height(gl_FragCoord.xy, 0.25), paper_height(gl_FragCoord.xy, 0.75));
    ivec2 there = inside(gl_FragCoord.xy + marks.y * wobble);
    vec3 at = texelFetch(wash, there, 0).xyz;
    o_ink = texelFetch(colors, there, 0);
    at.xy = at.z * mix(vec2(0.25, 0.0), vec2(1.0), vec2(stepped(at.x), stepped(at.y))); // a first thin wash
    o_wash = vec4(at, at.z * (0.35 + 0.65 * max(at.x, at.y)));
}
