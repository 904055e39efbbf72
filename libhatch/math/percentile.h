/* Percentiles of weighted values. */
#ifndef HATCH_MATH_PERCENTILE_H
#define HATCH_MATH_PERCENTILE_H

#include <stddef.h>

struct hatch_weighted {
    double value, weight; /* finite; weight at least 0 */
};

/* out[i]: the smallest value such that it and all below it weigh at least shares[i] of the whole; NaN
 * where there are none. Sorts values by value, then by weight, so that sums have one order on every
 * machine. shares: count_shares of 0 .. 1, rising. */
void hatch_percentiles(struct hatch_weighted *values, size_t count, const double *shares, size_t count_shares,
                       double *out);

#endif
