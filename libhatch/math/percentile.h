/* Percentiles of weighted values. */
#ifndef HATCH_MATH_PERCENTILE_H
#define HATCH_MATH_PERCENTILE_H

#include <stddef.h>

struct hatch_weighted {
    double value, weight; /* finite; weight at least 0 */
};

/* Computes weighted percentiles. For each share: the smallest value for which it and all smaller values together have
 * at least that share of the total weight.
 *   values  in, out: sorted on return, by value, then by weight, so that sums have one order on every machine
 *   shares  0 .. 1, ascending
 *   out     one per share; NaN where there are no values */
void hatch_percentiles(struct hatch_weighted *values, size_t count, const double *shares, size_t share_count,
                       double *out);

#endif
