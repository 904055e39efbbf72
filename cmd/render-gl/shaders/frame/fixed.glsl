// Fixed-point numbers of 64.64 bits in two's complement, lowest word first: the origins of pieces (near/near.h).
uint word_of(uvec4 number, int word)
{
    if (word < 0)
        return 0u;
    return word < 4 ? number[word] : (number.w >> 31) * 0xffffffffu;
}

// Returns 32 bits of a number, from bit `low` on.
uint bits_from(uvec4 number, int low)
{
    int word = low >> 5, shift = low & 31;
    uint bits = word_of(number, word) >> shift;
    return shift > 0 ? bits | word_of(number, word + 1) << (32 - shift) : bits;
}

// Returns a fixed-point number of 64.64 bits, divided by 2^depth and taken modulo 4: 32 of its bits, two of them before
// the binary point.
float bits_at(uvec4 number, int depth)
{
    return float(bits_from(number, depth + 34)) / 1073741824.0;
}

// Returns the multiple of 4 that bits_at() leaves out, modulo 2^32.
int fours_at(uvec4 number, int depth)
{
    return int(bits_from(number, depth + 64) & ~3u);
}
