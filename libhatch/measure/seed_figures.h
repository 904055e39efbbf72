/* Measurements of a seed set; hatchstat(1) has the formulas. */
#ifndef HATCH_MEASURE_SEED_FIGURES_H
#define HATCH_MEASURE_SEED_FIGURES_H

#include "seed/spread.h"

#define HATCH_SEED_FIGURES_MAX 8192u /* measurements of quadratic time are made up to this number of seed points */
#define HATCH_SEED_RINGS 4u          /* number of radii in the spectrum: 1/4, 1/2, 3/4 and 1 times sqrt(N) */

/* Distances are relative to the hexagonal bound (hatch_spread_bound). */
struct hatch_seed_figures {
    uint32_t seeds;
    uint32_t uneven;        /* number of digit patterns, of all lengths, that occur too often or too rarely */
    uint32_t astray;        /* number of coordinates that zooming by two does not map to those of the next seed point */
    double distance;        /* smallest distance between two seed points */
    double distance_sparse; /* smallest distance between two of those that remain at the next level */
    double distance_random; /* smallest distance between independent random points, mean of many sets */
    double distance_bayer;  /* smallest distance between the first N points of the recursive Bayer order */
    double discrepancy;     /* star discrepancy, 0 .. 1 */
    double correlation;     /* of u and v, -1 .. 1; NaN where u or v of all seed points is the same */
    double power[HATCH_SEED_RINGS]; /* mean of the power spectrum at a radius; 1 for random points; NaN where none is */
    bool complete;                  /* false: astray, discrepancy and power were not measured */
};

/* Measures a seed set. Time is quadratic up to HATCH_SEED_FIGURES_MAX seed points.
 *   throws  number of random sets for distance_random, at least 1 */
enum hatch_status hatch_measure_seeds(const struct hatch_seed_set *set, uint32_t throws, struct hatch_arena *scratch,
                                      struct hatch_seed_figures *figures, struct hatch_err *err) HATCH_MUST_USE;

#endif
