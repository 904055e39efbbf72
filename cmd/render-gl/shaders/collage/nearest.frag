// A step of jump flooding (Rong and Tan 2006): the nearest core of a strip of the same item. Cores of wide strips come
// before those of narrower ones, and the pixel's own strip, where its disk covers the pixel, before others.
#include "collage/strips.glsl"

layout(binding = UNIT_SOURCE) uniform sampler2D cores;
layout(binding = UNIT_TECHNIQUE + 1) uniform sampler2D away;
layout(location = UNIFORM_B) uniform float radius; // of the disk that fits into a wide strip, in pixels
layout(location = UNIFORM_C) uniform int jump;     // pixels
out vec4 o_core; // number of the strip; where the core is, in pixels from here; 2: wide, 1: half as wide, 0: none

#define REACH 3.0 // radii within which a pixel can become one of another strip

void main()
{
    ivec2 here = ivec2(gl_FragCoord.xy), last = textureSize(cores, 0) - 1;
    float strip = texelFetch(away, here, 0).x, best = 0.0;
    o_core = vec4(strip, 0.0, 0.0, 0.0);
    for (int i = 0; i < 9; i++) {
        ivec2 step = jump * ivec2(i % 3 - 1, i / 3 - 1), at = here + step;
        vec4 near = at == clamp(at, ivec2(0), last) ? texelFetch(cores, at, 0) : vec4(0.0);
        near.yz += vec2(step);
        float disk = 0.5 * radius * near.w, distance = length(near.yz);
        bool own = near.x == strip && distance <= disk + 0.5;
        float rank = near.w + (own ? 0.5 : 0.0) + 0.4 / (1.0 + distance);
        bool carried = strip == 0.0 && jump > 1; // pixels beside thin items pass cores on
        if (near.w > 0.0 && (carried || same_item(near.x, strip)) && (own || distance <= REACH * radius) &&
            rank > best) {
            best = rank;
            o_core = near;
        }
    }
}
