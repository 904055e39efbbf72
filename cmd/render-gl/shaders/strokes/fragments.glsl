// Fragments: a pixel that a stroke covers, with the stroke's id. x, y: the id; bit 0 of x is the index of the ink, and
// the six bits above it are the layer. z: column and row of the pixel, 16 bits each. w: t in the lower 16 bits, and
// above them the share of the pixel that is covered. technique/strokes/strokes.h has the same.
const uint ID_LAYER_SHIFT = 1u, ID_HASH_SHIFT = 7u;

layout(std430, binding = STORAGE_FRAGMENTS) buffer Fragments {
    uint fragment_count; // those found; may exceed the length of the array
    uint unused[3];
    uvec4 fragments[];
};
