// A table of strokes in a texture: ids, 0 for a free slot. It is only read while fragments are routed; the next table
// is drawn meanwhile, so that the fragments need not wait for one another (Szecsi et al., Tonal Art Maps with Image
// Space Strokes, 3). The last row of the texture is no part of the table.
#include "strokes/hash.glsl"

layout(binding = UNIT_TECHNIQUE) uniform usampler2D table;

const uint PROBES = 16u; // slots that a stroke may have

ivec2 texel_of(uint slot)
{
    uint width = uint(textureSize(table, 0).x);
    return ivec2(slot % width, slot / width);
}

// Returns the slot of an id, or the first free one that it may have, or else the one after the last.
uint slot_of(uvec2 id)
{
    ivec2 size = textureSize(table, 0);
    uint count = uint(size.x * (size.y - 1)), chosen = count;
    for (uint n = 0u; n < PROBES; n++) {
        uint slot = probe(id, n, count);
        uvec2 other = texelFetch(table, texel_of(slot), 0).xy;
        if (other == id)
            return slot;
        if (other == uvec2(0u) && chosen == count)
            chosen = slot;
    }
    return chosen;
}
