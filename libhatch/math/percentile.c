#include "math/percentile.h"

#include <math.h>
#include <stdlib.h>

static int compare(const void *a, const void *b)
{
    const struct hatch_weighted *x = a, *y = b;
    int order = (x->value > y->value) - (x->value < y->value);
    return order ? order : (x->weight > y->weight) - (x->weight < y->weight);
}

void hatch_percentiles(struct hatch_weighted *values, size_t count, const double *shares, size_t share_count,
                       double *out)
{
    double total = 0, sum = 0;
    size_t next = 0;
    for (size_t i = 0; i < share_count; i++)
        out[i] = NAN;
    if (count > 0)
        qsort(values, count, sizeof *values, compare);
    for (size_t i = 0; i < count; i++)
        total += values[i].weight;
    for (size_t i = 0; i < count; i++) {
        sum += values[i].weight;
        while (next < share_count && (sum >= shares[next] * total || i + 1 == count))
            out[next++] = values[i].value;
    }
}
