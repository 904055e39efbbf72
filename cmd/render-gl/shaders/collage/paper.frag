// Draws the paper of each pixel's strip, from the texture of its band.
#include "frame/amounts.glsl"
#include "solid/zoom.glsl"
#include "collage/strips.glsl"

layout(binding = UNIT_TECHNIQUE + 1) uniform sampler2D strips;
out vec4 o_paper;

void main()
{
    base_holes();
    float band = strip_band(max(texelFetch(strips, ivec2(gl_FragCoord.xy), 0).x, 1.0));
    int solid = min(int(band * float(SOLIDS) / edges.x), SOLIDS - 1);
    vec3 texture = texture_color(solid) / max(colors[solid].offset.w, 0.02);
    vec2 amount = vec2((band + 0.5) / edges.x, 0.0);
    if (counts.z == 2)
        amount = vec2(max(2.0 * amount.x - 1.0, 0.0), max(1.0 - 2.0 * amount.x, 0.0));
#if CHANNELS == 3
    vec3 dark = 1.0 - mix(vec3(1.0), texture, marks.x) * (1.0 - amount.x); // papers in their own colours
#else
    vec3 dark = amount.x + marks.x * (0.1 + min(amount.x, 1.0 - amount.x)) * (1.0 - texture);
#endif
    vec3 light = amount.y + marks.x * min(amount.y, 1.0 - amount.y) * (texture - 1.0);
    o_paper = vec4(base_color(0.0) * own_ink_on_paper(clamp(dark, 0.0, 1.0), clamp(light, 0.0, 1.0)), 1.0);
}
