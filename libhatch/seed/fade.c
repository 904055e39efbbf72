#include "seed/fade.h"

#include <math.h>

#define OVERLAP_MIN 1e-6 /* below it a stroke is there or not */

double hatch_fade_share(enum hatch_fade_law law, double m)
{
    return law == HATCH_FADE_PAPER ? 1 - m : (pow(4, 1 - m) - 1) / 3;
}

/* Weights fall from 1 to 0 over a stretch of ranks as wide as overlap / (1 - overlap), which moves from
 * below rank 0 to above rank 1 while x goes from 0 to 1. The mean over ranks is a quadratic at both
 * ends, where the stretch is cut off, and linear between; this is its inverse. */
double hatch_fade_front(double f, double overlap)
{
    double p = fmax(overlap, OVERLAP_MIN), q = 1 - p;
    double less = fmin(p, q), more = fmax(p, q);
    if (f <= less / (2 * more))
        return sqrt(2 * p * q * f);
    if (f >= 1 - less / (2 * more))
        return 1 - sqrt(2 * p * q * (1 - f));
    return f * more + less / 2;
}

double hatch_fade_weight(double f, double rank, double overlap)
{
    double p = fmax(overlap, OVERLAP_MIN);
    return fmin(fmax((hatch_fade_front(f, overlap) - rank * (1 - p)) / p, 0), 1);
}
