/* Ranges of a parameter in which linear functions are not negative. */
#ifndef HATCH_MATH_RANGE_H
#define HATCH_MATH_RANGE_H

#include <math.h>
#include <stdbool.h>

/* Narrows begin .. end, within 0 .. 1, to where a linear function with the given values at 0 and at 1 is at least 0.
 * Returns whether any of it remains. */
static inline bool hatch_range_keep(double at_0, double at_1, double *begin, double *end)
{
    if (at_0 < 0 && at_1 < 0)
        *end = -1;
    else if (at_0 < 0)
        *begin = fmax(*begin, at_0 / (at_0 - at_1));
    else if (at_1 < 0)
        *end = fmin(*end, at_0 / (at_0 - at_1));
    return *begin <= *end;
}

#endif
