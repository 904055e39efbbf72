// Ids of strokes, and double hashing. Of the first word of an id, bit 0 is the index of the ink, the six bits above it
// are the layer, and the rest is a hash that all parts of a divided stroke have.
const uint ID_LAYER_SHIFT = 1u, ID_HASH_SHIFT = 7u;

// Returns the number that chooses the look of a stroke; 20 bits. low: the first word of its id
uint stroke_number(uint low)
{
    return low >> ID_HASH_SHIFT & 0xfffffu;
}

// Returns the slot that the id tries after n others.
// slots: size of the table, a power of two
uint probe(uvec2 id, uint n, uint slots)
{
    return (id.x ^ id.x >> 15) + n * (id.y | 1u) & slots - 1u;
}
