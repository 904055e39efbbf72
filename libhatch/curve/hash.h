/* Random bits for strokes. shaders/traced/noise.glsl of render-gl has the same function. */
#ifndef HATCH_CURVE_HASH_H
#define HATCH_CURVE_HASH_H

#include <stdint.h>

static inline uint32_t hatch_mix_bits(uint32_t x)
{
    x ^= x >> 16;
    x *= 0x7feb352du;
    x ^= x >> 15;
    x *= 0x846ca68bu;
    return x ^ x >> 16;
}

#endif
