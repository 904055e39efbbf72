// Pass of the watercolour that paints each pixel: pigment on paper (Bousseau et al. 2006,
// section 3). A pigment density d turns the colour C of a wash into C - (C - C^2) (d - 1).
#include "solid/image.glsl"

out vec4 o_color;

float luminance(vec3 color)
{
    return dot(color, vec3(0.2126, 0.7152, 0.0722));
}

// Returns the colour of a transparent layer of ink that is as dark as if an amount of the ink covered the paper. Thin
// layers absorb less, so that they are more colourful: of thickness q, paper * (ink / paper)^q. Its luminance is convex
// in q. Unless it falls or rises all the way from paper to ink, no such thickness leads from one to the other, and the
// amount is the thickness.
vec3 glaze(vec3 ink, float amount)
{
    vec3 least = vec3(0.004), base = max(paper.rgb, least), full = max(ink, least), rate = log(full / base);
    float low = 0.0, high = 1.0, want = mix(luminance(base), luminance(full), amount);
    float way = sign(luminance(full) - luminance(base));
    if (way * luminance(rate * base) <= 0.0 || way * luminance(rate * full) <= 0.0)
        return base * exp(amount * rate);
    for (int i = 0; i < 10; i++) {
        float middle = 0.5 * (low + high);
        if (way * (luminance(base * exp(middle * rate)) - want) < 0.0)
            low = middle;
        else
            high = middle;
    }
    return base * exp(0.5 * (low + high) * rate);
}

#ifdef COLORS
// Returns the colour of a surface under ink: a thin layer of its own colour in the light, a thicker one in the shade,
// and a glaze of ink that lets some of it through.
vec3 painted(vec3 surface, float amount)
{
    return pow(max(surface, vec3(0.004)), vec3(0.6 + 0.4 * amount)) * glaze(ink.rgb, 0.85 * amount);
}
#else
vec3 painted(vec3 ink, float amount)
{
    return glaze(ink, amount);
}
#endif

void main()
{
    ivec2 here = ivec2(gl_FragCoord.xy);
    vec4 wet = texelFetch(wash, here, 0), texel = texelFetch(grain, here, 0);
    float rank = texel.x, height = 2.0 * rank - 1.0;
    float edge = wet.w - texelFetch(blurred, here, 0).x;
    wet.x += 3.0 * zoom.w * max(-edge, 0.0) * (1.0 + texel.y) * (1.0 - wet.x) * wet.z; // ink of wetter washes
    vec3 color = painted(texelFetch(colors, here, 0).rgb, wet.x);
    color += wet.y * (light_ink.rgb - color);
    float density = 1.0 + marks.x * (0.4 * height + 0.6 * texel.y) + 5.0 * marks.w * max(edge, 0.0);
    vec3 base = clamp(color, 0.004, 0.97);
    color = clamp(color - (base - base * base) * (density - 1.0), 0.0, 1.0);
    float bare = smoothstep(0.0, 0.12, rank - 1.0 + marks.z * (1.0 - max(wet.x, 0.25)) * wet.z);
    color = mix(paper.rgb, color, wet.z * (1.0 - bare));
    o_color = vec4(color * (1.0 - 0.25 * edges.z * max(-height, 0.0)), 1.0);
}
