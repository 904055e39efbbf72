/* Periodic gradient noise (Perlin 1985), in octaves. The lattice repeats after a whole number of cells along each
 * axis. */
#ifndef HATCH_SOLID_NOISE_H
#define HATCH_SOLID_NOISE_H

#include <math.h>
#include <stdbool.h>
#include <stdint.h>

#define HATCH_NOISE_OCTAVES_MAX 8u
#define HATCH_NOISE_GRADIENTS 256u

/* Gradients, for all noise of a texture. */
struct hatch_noise {
    float gradients[HATCH_NOISE_GRADIENTS][3]; /* unit vectors in random directions, whose sum is 0 */
};

/* The lattice of one octave. */
struct hatch_noise_lattice {
    uint32_t cells[3]; /* after which it repeats, along x, y and z; 1 .. 2^16 */
    uint32_t key;      /* lattices with different keys are independent */
    float shift[3];    /* added to positions, in cells */
};

/* Octaves of noise, each with twice the cells of the one before. */
struct hatch_noise_octaves {
    const struct hatch_noise *noise;
    uint32_t count; /* 1 .. HATCH_NOISE_OCTAVES_MAX */
    struct hatch_noise_lattice lattices[HATCH_NOISE_OCTAVES_MAX];
    float amplitudes[HATCH_NOISE_OCTAVES_MAX]; /* their sum is 1 */
};

/* Makes random gradients. */
void hatch_noise_make(uint64_t seed, struct hatch_noise *noise);

/* Makes octaves whose lattices are shifted against each other, so that their zeros do not coincide.
 *   noise   kept by reference
 *   stream  octaves of different streams are independent
 *   cells   of the first octave; octaves with more than cells_max along an axis are left out, except the first
 *   gain    amplitude of an octave relative to the one before, over 0 */
struct hatch_noise_octaves hatch_noise_octaves_make(const struct hatch_noise *noise, uint64_t seed, uint64_t stream,
                                                    const uint32_t cells[3], uint32_t cells_max, uint32_t count,
                                                    float gain);

/* Returns the noise of a lattice: within -1 .. 1, 0 at lattice points, with a continuous slope.
 *   at  position in cells, -2^15 .. 2^15 */
float hatch_noise_at(const struct hatch_noise *noise, const struct hatch_noise_lattice *lattice, const float at[3]);

/* Returns the sum of octaves, within -1 .. 1, or with `absolute` the sum of their absolute values.
 *   at  position in the cube, whose side is 1; positions beyond it repeat */
float hatch_noise_sum(const struct hatch_noise_octaves *octaves, const float at[3], bool absolute);

/* Returns x - floor(x), in 0 .. 1. */
static inline float hatch_noise_fraction(float x)
{
    return x - floorf(x);
}

/* Returns the cosine of an angle in turns, by a polynomial: the same on every processor. */
float hatch_noise_cosine(float turns);

/* Returns 3 x^2 - 2 x^3 of x, clamped to 0 .. 1: a smooth step. */
static inline float hatch_noise_step(float x)
{
    x = fminf(fmaxf(x, 0), 1);
    return x * x * (3 - 2 * x);
}

#endif
