/* Counter-based random numbers: each number is a function of (random seed, stream, index), so that the n-th number is
 * the same on any thread and in any order. Seed, stream and index are each mixed by SplitMix64's finaliser (Steele, Lea
 * & Flood, "Fast splittable pseudorandom number generators", OOPSLA 2014). */
#ifndef HATCH_BASE_RANDOM_H
#define HATCH_BASE_RANDOM_H

#include <stdint.h>

/* Returns a hash of x: SplitMix64's finaliser. */
static inline uint64_t hatch_random_mix(uint64_t x)
{
    x ^= x >> 30;
    x *= 0xbf58476d1ce4e5b9u;
    x ^= x >> 27;
    x *= 0x94d049bb133111ebu;
    return x ^ x >> 31;
}

/* The two halves of hatch_random_u64, for many numbers of one stream: the key of the stream, and a number of it. */
static inline uint64_t hatch_random_key(uint64_t seed, uint64_t stream)
{
    return hatch_random_mix(hatch_random_mix(seed + 0x9e3779b97f4a7c15u) ^ (stream + 0xd1b54a32d192ed03u));
}

static inline uint64_t hatch_random_at(uint64_t key, uint64_t index)
{
    return hatch_random_mix(key + (index + 1) * 0x9e3779b97f4a7c15u);
}

/* Returns 64 uniform bits. */
static inline uint64_t hatch_random_u64(uint64_t seed, uint64_t stream, uint64_t index)
{
    return hatch_random_at(hatch_random_key(seed, stream), index);
}

/* Returns a uniform number in [0, 1) that is a multiple of 2^-24, so that a float holds it exactly. */
static inline float hatch_random_unit_at(uint64_t key, uint64_t index)
{
    return (float)(hatch_random_at(key, index) >> 40) * 0x1p-24f;
}

/* The same for a number of a stream. */
static inline float hatch_random_unit(uint64_t seed, uint64_t stream, uint64_t index)
{
    return hatch_random_unit_at(hatch_random_key(seed, stream), index);
}

#endif
