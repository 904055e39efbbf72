// Double hashing.

// Returns the slot that the id tries after n others.
// slots: size of the table, a power of two
uint probe(uvec2 id, uint n, uint slots)
{
    return (id.x ^ id.x >> 15) + n * (id.y | 1u) & slots - 1u;
}
