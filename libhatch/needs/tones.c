#include "needs/tones.h"

#include <math.h>

#define STEPS 0x1p24 /* steps of tone from 0 to 1 */

void hatch_needs_add(struct hatch_needs_tones *tones, double tone)
{
    double clamped = fmin(fmax(tone, 0), 1);
    uint32_t bin = (uint32_t)fmin(clamped * HATCH_NEEDS_BINS, HATCH_NEEDS_BINS - 1);
    tones->count[bin]++;
    tones->sum[bin] += (uint64_t)(clamped * STEPS + 0.5);
}

double hatch_needs_excess(const struct hatch_needs_tones *tones, uint64_t pixels, double limit)
{
    double excess = 0;
    for (uint32_t i = 0; i < HATCH_NEEDS_BINS; i++)
        excess += fmax((double)tones->sum[i] / STEPS - limit * (double)tones->count[i], 0);
    return pixels ? excess / (double)pixels : 0;
}

double hatch_needs_darkest(const struct hatch_needs_tones *tones, uint64_t pixels, double tolerance)
{
    double most = tolerance * (double)pixels, sum = 0, count = 0;
    for (uint32_t bin = HATCH_NEEDS_BINS; bin-- > 0;) {
        double low = (double)bin / HATCH_NEEDS_BINS;
        sum += (double)tones->sum[bin] / STEPS;
        count += (double)tones->count[bin];
        if (sum - low * count > most)
            return (sum - most) / count;
    }
    return 0;
}

double hatch_needs_lightest(const struct hatch_needs_tones *tones, uint64_t pixels, double tolerance)
{
    double most = tolerance * (double)pixels, sum = 0, count = 0, greatest = 0;
    for (uint32_t bin = 0; bin < HATCH_NEEDS_BINS; bin++) {
        double high = (double)(bin + 1) / HATCH_NEEDS_BINS;
        if (tones->count[bin])
            greatest = (double)tones->sum[bin] / STEPS / (double)tones->count[bin];
        sum += (double)tones->sum[bin] / STEPS;
        count += (double)tones->count[bin];
        if (high * count - sum > most)
            return fmin((sum + most) / count, high);
    }
    return greatest;
}
