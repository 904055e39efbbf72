// Second pass of the watercolour, for each pixel: flat washes whose borders wobble.
#include "solid/image.glsl"

layout(location = 0) out vec4 o_wash; // amounts of dark and light ink; coverage; wetness, whose steps are darkened
layout(location = 1) out vec4 o_ink;  // as in marks.frag
layout(location = 2) out vec4 o_grain; // as in marks.frag; rank 0.5 where the pixel shows the paper behind the scene

// Returns an amount of ink in soft steps.
float stepped(float amount)
{
    float at = amount * edges.x, whole = floor(at);
    return min((whole + smoothstep(0.3, 0.7, at - whole)) / edges.x, 1.0);
}

#ifdef PICTURE
// Returns the amount of an ink that turns the colour of the paper into one that is `apart` from it.
float amount_of(vec3 apart, vec3 full)
{
    return clamp(dot(apart, full) / max(dot(full, full), 1e-6), 0.0, 1.0);
}

// Returns the amounts of dark and light ink, of which one is none, and the coverage of a sample. A picture is ink on
// paper; ink may be beside the surfaces, too.
vec3 drawn_at(ivec2 at)
{
    vec3 dark = ink.rgb - paper.rgb, light = light_ink.rgb - paper.rgb;
    vec3 apart = texelFetch(wash, at, 0).rgb - paper.rgb;
    vec2 amount = vec2(amount_of(apart, dark), 0.0);
    if (counts.z == 2) {
        float other = amount_of(apart, light);
        if (distance(apart, other * light) < distance(apart, amount.x * dark))
            amount = vec2(0.0, other);
    }
    if (texelFetch(colors, at, 0).a > 0.0)
        return vec3(amount, 1.0);
    return vec3(step(0.02, amount), max(amount.x, amount.y));
}

// Returns the colour of a wash: where there is no surface, that of the ink.
vec3 color_at(ivec2 at)
{
    vec4 color = texelFetch(colors, at, 0);
#ifdef COLORS
    return color.a > 0.0 ? color.rgb : vec3(1.0);
#else
    return color.a > 0.0 ? color.rgb : ink.rgb;
#endif
}

float surface_at(ivec2 at)
{
    return texelFetch(colors, at, 0).a;
}
#else
vec3 drawn_at(ivec2 at)
{
    return texelFetch(wash, at, 0).xyz;
}

vec3 color_at(ivec2 at)
{
    return texelFetch(colors, at, 0).rgb;
}

float surface_at(ivec2 at)
{
    return texelFetch(wash, at, 0).z;
}
#endif

#ifdef COLORS
#define THIN 0.0 // the surface's colour is the first wash
#else
#define THIN 0.25 // amount of ink in a first thin wash
#endif

void main()
{
    ivec2 first = ivec2(gl_FragCoord.xy) * side_samples();
    vec2 slow = 0.25 * gl_FragCoord.xy - 0.75 * viewport.zw; // a quarter of the frequency, in all tiles alike
    vec2 paper_wobble = vec2(paper_height(slow, 0.25, 1.0), paper_height(slow, 0.75, 1.0));
    vec4 grains = vec4(0.0);
    vec3 washes = vec3(0.0), inks = vec3(0.0);
    float own = 0.0;
    for (int y = 0; y < side_samples(); y++)
        for (int x = 0; x < side_samples(); x++) {
            ivec2 here = first + ivec2(x, y);
            vec4 texel = texelFetch(grain, here, 0);
            float surface = surface_at(here);
            ivec2 there = inside(vec2(here) + 0.5 + marks.y * (surface > 0.0 ? texel.yz : paper_wobble));
            vec3 at = drawn_at(there);
            washes += at.z * vec3(at.xy, 1.0);
            inks += at.z * color_at(there);
            grains += surface * texel;
            own += surface;
        }
    float whole = max(washes.z, 1e-3);
    vec2 amount = washes.xy / whole;
    amount = mix(vec2(THIN, 0.0), vec2(1.0), vec2(stepped(amount.x), stepped(amount.y)));
    float coverage = washes.z / curve.w;
    o_wash = vec4(amount, coverage, coverage * (0.35 + 0.65 * max(amount.x, amount.y)));
    o_ink = vec4(inks / whole, 1.0);
    o_grain = own > 0.0 ? grains / own : vec4(0.5 + 0.5 * paper_height(gl_FragCoord.xy, 0.5, 0.0), 0.0, 0.0, 0.0);
}
