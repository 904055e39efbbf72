// Gives each pixel to the strip of its core, so that strips too narrow for their borders are gone. Those that have no
// wide strip near them stay, with narrower borders.
#include "collage/strips.glsl"

layout(binding = UNIT_SOURCE) uniform sampler2D cores;
layout(binding = UNIT_TECHNIQUE + 1) uniform sampler2D away;
layout(binding = UNIT_TECHNIQUE + 2) uniform sampler2D strips;
layout(location = UNIFORM_B) uniform float width; // of borders, in pixels
layout(location = UNIFORM_C) uniform int pixel_side;    // samples along it
out vec4 o_strip; // as collage/away.frag reads it

void main()
{
    ivec2 here = ivec2(gl_FragCoord.xy), last = textureSize(cores, 0) - 1;
    vec4 own = texelFetch(cores, here, 0), around;
    for (int i = 0; i < 4; i++)
        around[i] = texelFetch(cores, clamp(here + ivec2(i % 2, i / 2) * 2 - 1, ivec2(0), last), 0).x;
    int covered = 0;
    for (int i = 0; i < pixel_side * pixel_side; i++) {
        float strip = texelFetch(strips, here * pixel_side + ivec2(i % pixel_side, i / pixel_side), 0).x;
        bool stays = strip == 0.0 || !same_item(strip, own.x) || any(equal(around, vec4(strip)));
        covered += int(strip == own.x || !stays);
    }
    float narrower = own.w == 2.0 ? 1.0 : own.w == 1.0 ? 0.5 : 0.3;
    float border = max(width * narrower * texelFetch(away, here, 0).w, min(width, 1.0));
    o_strip = vec4(own.x, 0.0, float(covered) / float(pixel_side * pixel_side), border);
}
