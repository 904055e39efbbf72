#include "seed/fade.h"

#include <math.h>

double hatch_fade_share(enum hatch_fade_law law, double m)
{
    return law == HATCH_FADE_PAPER ? 1 - m : (pow(4, 1 - m) - 1) / 3;
}

/* The inverse of hatch_fade_share for HATCH_FADE_EVEN. */
double hatch_fade_death(double rank)
{
    return 1 - log2(1 + 3 * rank) / 2;
}

/* Over the ranks, weights fall from 1 to 0 within an interval of width overlap / (1 - overlap). It moves from below
 * rank 0 to above rank 1 while the front goes from 0 to 1. The mean weight is quadratic in the front at both ends,
 * where the interval is cut off, and linear in between; this function is its inverse. */
double hatch_fade_front(double f, double overlap)
{
    double p = fmax(overlap, HATCH_FADE_OVERLAP_MIN), q = 1 - p;
    double less = fmin(p, q), more = fmax(p, q);
    if (f <= less / (2 * more))
        return sqrt(2 * p * q * f);
    if (f >= 1 - less / (2 * more))
        return 1 - sqrt(2 * p * q * (1 - f));
    return f * more + less / 2;
}

struct hatch_fade hatch_fade_at(enum hatch_fade_law law, double m, double overlap)
{
    double p = fmax(overlap, HATCH_FADE_OVERLAP_MIN);
    if (law == HATCH_FADE_WEIGHTED)
        return (struct hatch_fade){-m / p, 1 / p, 1 / p};
    double front = hatch_fade_front(hatch_fade_share(law, m), overlap);
    return (struct hatch_fade){(front - (1 - p)) / p, (1 - p) / p, 0};
}

double hatch_fade_weight(const struct hatch_fade *fade, double life, double more)
{
    return fmin(fmax(fade->base + fade->slope * life + more, 0), 1);
}
