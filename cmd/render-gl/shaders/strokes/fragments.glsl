// Fragments: a pixel that a stroke covers, with the stroke's id. x, y: the id. z: column and row of the pixel, 16 bits
// each. w: t in the lower 16 bits, and above them the share of the pixel that is covered; but bits 16 and 17 say that
// the surface is a patch, and that another patch lies over it.
#include "strokes/hash.glsl"

const uint FRAGMENT_LAPPED = 0x10000u, FRAGMENT_BELOW = 0x20000u;

layout(std430, binding = STORAGE_FRAGMENTS) buffer Fragments {
    uint fragment_count; // those found; may exceed the length of the array
    uint unused[3];
    uvec4 fragments[];
};
