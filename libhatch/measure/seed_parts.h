/* Private to the figures of seed sets: those that take quadratic time. */
#ifndef HATCH_MEASURE_SEED_PARTS_H
#define HATCH_MEASURE_SEED_PARTS_H

#include "measure/seed_figures.h"

/* Counts coordinates that zooming by two does not map to the next seed point, in exact integers: with
 * s = b / (2^N - 1), 2 b mod (2^N - 1) must be the next b, for u and for v. */
enum hatch_status hatch_measure_astray(const struct hatch_seed_set *set, struct hatch_arena *scratch, uint32_t *astray,
                                       struct hatch_err *err) HATCH_MUST_USE;

/* Computes the mean of |sum of e^(-2 pi i k·s)|² / N over the integer frequencies k whose length is within
 * sqrt(N) / 8 of each ring's radius. */
enum hatch_status hatch_measure_spectrum(const struct hatch_seed_point *places, uint32_t count,
                                         struct hatch_arena *scratch, double power[HATCH_SEED_RINGS],
                                         struct hatch_err *err) HATCH_MUST_USE;

#endif
