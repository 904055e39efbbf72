// Volumes: tone is the third coordinate (Webb et al. 2002, section 3.1). Texels hold reflectance.
#include "frame/amounts.glsl"
#include "frame/inks.glsl"
#include "tones/tones.glsl"

in vec2 v_texcoord;
out vec4 o_color;

// Returns the coverage at a tone. Texture filters do not interpolate in the half slice at either end of the range of
// tones. There, coverage fades to paper, and at the dark end to solid ink if the volume reaches it. The slices of the
// darkest tones may have been left out.
vec3 coverage(float tone)
{
    float slices = float(counts.y), all = targets[0].x, half_slice = 0.5 / all;
#ifdef LAYERED
    float place = clamp(tone * all - 0.5, 0.0, slices - 1.0), below = floor(place);
    vec3 texel = mix(read_columns(below).rgb, read_columns(min(below + 1.0, slices - 1.0)).rgb, place - below);
#else
    vec3 texel = read_columns(tone * all / slices).rgb;
    half_slice = min(half_slice * exp2(max(column_level, 0.0)), 0.5);
#endif
    texel = mix(vec3(1.0), texel, min(tone / half_slice, 1.0));
    return 1.0 - texel * (counts.w > 0 ? min((1.0 - tone) / half_slice, 1.0) : 1.0);
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
