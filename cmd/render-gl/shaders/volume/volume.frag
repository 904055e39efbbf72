// Volumes: tone is the third coordinate (Webb et al. 2002, section 3.1). Texels hold reflectance.
#include "frame/amounts.glsl"
#include "frame/inks.glsl"
#include "tones/tones.glsl"

in vec2 v_texcoord;
out vec4 o_color;

// Returns how far a tone is from one end of the tones in what the texture unit returns: the outermost slices stand for
// all tones beyond them. outermost: their distances, of two levels; share: of the second one.
float distance_held(float distance, vec2 outermost, float share)
{
    return mix(max(distance, outermost.x), max(distance, outermost.y), share);
}

// Returns the coverage at a tone. Texture filters do not interpolate in the half slice at either end of the range of
// tones. There, coverage goes on to paper, and at the dark end to the darkest tone of the map. The slices of the
// darkest tones may have been left out.
vec3 coverage(float tone)
{
    float slices = float(counts.y), top = slices / targets[0].x, light = 1.0 - min(tone, shade.x), share = 0.0;
    vec2 depths = vec2(slices);
#ifdef LAYERED
    float place = clamp(tone / top * slices - 0.5, 0.0, slices - 1.0), below = floor(place);
    vec3 texel = mix(read_columns(below).rgb, read_columns(min(below + 1.0, slices - 1.0)).rgb, place - below);
#else
    vec3 texel = read_columns(tone / top).rgb;
    float level = max(column_level, 0.0);
    share = fract(level);
    depths = max(floor(slices * exp2(-floor(level) - vec2(0.0, 1.0))), 1.0);
#endif
    vec2 half_slice = 0.5 * top / depths;
    texel = 1.0 - (1.0 - texel) * (tone / distance_held(tone, half_slice, share));
    return 1.0 - texel * (light / distance_held(light, 1.0 - top + half_slice, share));
}

void main()
{
    aim(v_texcoord);
    base_holes();
    vec2 asked = amounts();
    vec3 light = vec3(0.0);
#ifdef TWO_INKS
    light = coverage(asked.y);
#endif
    o_color = vec4(ink_on_paper(coverage(asked.x), light), opacity);
}
