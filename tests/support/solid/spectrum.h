/* Power spectra of square pictures. */
#ifndef HATCH_TEST_SPECTRUM_H
#define HATCH_TEST_SPECTRUM_H

#include <complex.h>
#include <math.h>
#include <stddef.h>

#define SPECTRUM_SIZE 128
#define SPECTRUM_PI 3.141592653589793

/* The discrete Fourier transform of SPECTRUM_SIZE numbers, in place, at a distance of `step` from each other. */
static inline void spectrum_line(double complex *at, size_t step)
{
    static double complex turned[SPECTRUM_SIZE];
    for (size_t i = 0; i < SPECTRUM_SIZE; i++) {
        size_t mirrored = 0;
        for (size_t bit = 1, back = SPECTRUM_SIZE / 2; bit < SPECTRUM_SIZE; bit *= 2, back /= 2)
            mirrored |= i & bit ? back : 0;
        turned[mirrored] = at[i * step];
    }
    for (size_t half = 1; half < SPECTRUM_SIZE; half *= 2)
        for (size_t i = 0; i < SPECTRUM_SIZE; i++)
            if (!(i & half)) {
                double complex other = turned[i + half] * cexp(-SPECTRUM_PI * I * (double)(i % half) / (double)half);
                turned[i + half] = turned[i] - other;
                turned[i] += other;
            }
    for (size_t i = 0; i < SPECTRUM_SIZE; i++)
        at[i * step] = turned[i];
}

/* Computes the mean power on rings of frequencies: power[f] is that of about f periods along a side. The picture is
 * faded out towards its edges.
 *   values  SPECTRUM_SIZE rows of SPECTRUM_SIZE
 *   power   out: SPECTRUM_SIZE / 2 rings */
static inline void spectrum_of(const double *values, double *power)
{
    static double complex waves[SPECTRUM_SIZE * SPECTRUM_SIZE];
    size_t count[SPECTRUM_SIZE / 2] = {0};
    double mean = 0;
    for (size_t i = 0; i < SPECTRUM_SIZE * SPECTRUM_SIZE; i++)
        mean += values[i] / (SPECTRUM_SIZE * SPECTRUM_SIZE);
    for (size_t i = 0; i < SPECTRUM_SIZE * SPECTRUM_SIZE; i++) {
        double x = sin(SPECTRUM_PI * ((double)(i % SPECTRUM_SIZE) + 0.5) / SPECTRUM_SIZE);
        double y = sin(SPECTRUM_PI * ((double)(i / SPECTRUM_SIZE) + 0.5) / SPECTRUM_SIZE);
        waves[i] = (values[i] - mean) * x * x * y * y;
    }
    for (size_t i = 0; i < SPECTRUM_SIZE; i++)
        spectrum_line(waves + i * SPECTRUM_SIZE, 1);
    for (size_t i = 0; i < SPECTRUM_SIZE; i++)
        spectrum_line(waves + i, SPECTRUM_SIZE);
    for (size_t ring = 0; ring < SPECTRUM_SIZE / 2; ring++)
        power[ring] = 0;
    for (size_t i = 0; i < SPECTRUM_SIZE * SPECTRUM_SIZE; i++) {
        double x = (double)(i % SPECTRUM_SIZE), y = (double)(i / SPECTRUM_SIZE);
        size_t ring = (size_t)lround(hypot(fmin(x, SPECTRUM_SIZE - x), fmin(y, SPECTRUM_SIZE - y)));
        if (ring < SPECTRUM_SIZE / 2) {
            power[ring] += creal(waves[i] * conj(waves[i]));
            count[ring]++;
        }
    }
    for (size_t ring = 0; ring < SPECTRUM_SIZE / 2; ring++)
        power[ring] /= (double)count[ring];
}

/* Returns the frequency of the largest power, in periods along a side, interpolated between rings. */
static inline double spectrum_peak(const double *power)
{
    size_t most = 2;
    for (size_t ring = 2; ring + 1 < SPECTRUM_SIZE / 2; ring++)
        most = power[ring] > power[most] ? ring : most;
    double before = power[most - 1], here = power[most], after = power[most + 1];
    return (double)most + 0.5 * (before - after) / (before - 2 * here + after);
}

#endif
