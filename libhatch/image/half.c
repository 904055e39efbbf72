/* Conversion to and from IEEE 754 binary16. The code selects values with masks instead of branches, and loops over
 * blocks of a fixed length, because gcc at -O2 vectorises only such loops. */
#include "image/image.h"

#include <string.h>

#define BLOCK 64u

static inline uint32_t bits_of(float value)
{
    uint32_t bits;
    memcpy(&bits, &value, sizeof bits);
    return bits;
}

static inline float float_of(uint32_t bits)
{
    float value;
    memcpy(&value, &bits, sizeof value);
    return value;
}

static inline int32_t choose(int condition, int32_t yes, int32_t no)
{
    int32_t mask = -condition;
    return (yes & mask) | (no & ~mask);
}

static inline uint16_t half_of(float value)
{
    uint32_t bits = bits_of(value);
    int32_t magnitude = (int32_t)(bits & 0x7fffffffu);
    int32_t odd = magnitude >> 13 & 1;
    int32_t normal = (magnitude - 0x38000000 + 0xfff + odd) >> 13;
    /* below the smallest normal half, adding 0.5 shifts the mantissa into place and rounds it */
    int32_t subnormal = (int32_t)bits_of(float_of((uint32_t)magnitude) + 0.5f) - 0x3f000000;
    int32_t half = choose(magnitude < 0x38800000, subnormal, normal);
    half = choose(magnitude >= 0x47800000, 0x7c00, half); /* too large, or infinite */
    half = choose(magnitude > 0x7f800000, 0x7e00, half);  /* not a number */
    return (uint16_t)((uint32_t)half | (bits >> 16 & 0x8000u));
}

static inline float float_of_half(uint16_t half)
{
    uint32_t sign = (uint32_t)(half & 0x8000u) << 16;
    uint32_t magnitude = (uint32_t)(half & 0x7fffu) << 13;
    uint32_t bits = bits_of(float_of(magnitude) * 0x1p112f);
    bits |= (uint32_t) - (int32_t)(magnitude >= 0x0f800000u) & 0x7f800000u; /* infinite, or not a number */
    return float_of(sign | bits);
}

uint16_t hatch_half_from_float(float value)
{
    return half_of(value);
}

float hatch_float_from_half(uint16_t half)
{
    return float_of_half(half);
}

static void narrow_block(const float *restrict in, uint16_t *restrict out)
{
    for (size_t i = 0; i < BLOCK; i++)
        out[i] = half_of(in[i]);
}

static void widen_block(const uint16_t *restrict in, float *restrict out)
{
    for (size_t i = 0; i < BLOCK; i++)
        out[i] = float_of_half(in[i]);
}

void hatch_halves_from_floats(const float *values, size_t stride, uint16_t *halves, size_t count)
{
    for (; count >= BLOCK; count -= BLOCK, values += BLOCK * stride, halves += BLOCK) {
        float gathered[BLOCK];
        for (size_t i = 0; stride != 1 && i < BLOCK; i++)
            gathered[i] = values[i * stride];
        narrow_block(stride == 1 ? values : gathered, halves);
    }
    for (size_t i = 0; i < count; i++)
        halves[i] = half_of(values[i * stride]);
}

void hatch_floats_from_halves(const uint16_t *halves, size_t count, float *values, size_t stride)
{
    for (; count >= BLOCK; count -= BLOCK, values += BLOCK * stride, halves += BLOCK) {
        float widened[BLOCK];
        widen_block(halves, stride == 1 ? values : widened);
        for (size_t i = 0; stride != 1 && i < BLOCK; i++)
            values[i * stride] = widened[i];
    }
    for (size_t i = 0; i < count; i++)
        values[i * stride] = float_of_half(halves[i]);
}
