/* Figures of a seed set; hatchstat(1) has the formulas. */
#ifndef HATCH_MEASURE_SEED_FIGURES_H
#define HATCH_MEASURE_SEED_FIGURES_H

#include "seed/spread.h"

#define HATCH_SEED_FIGURES_MAX 8192u /* seed points; in larger sets figures of quadratic time are not measured */
#define HATCH_SEED_RINGS 4u          /* radii in the spectrum: 1/4, 1/2, 3/4 and 1 times sqrt(N) */

/* Distances are relative to the hexagonal bound. */
struct hatch_seed_figures {
    uint32_t seeds;
    uint32_t uneven;                /* digit patterns, of all lengths, that occur too often or too rarely */
    uint32_t astray;                /* coordinates that zooming by two does not map to the next seed point */
    double distance;                /* minimum between two seed points */
    double distance_sparse;         /* minimum between those that remain at the next level */
    double distance_random;         /* minimum between independent random points, mean of many sets */
    double distance_bayer;          /* minimum between the first N points of the recursive Bayer order */
    double discrepancy;             /* star discrepancy, 0 .. 1 */
    double correlation;             /* of u and v, -1 .. 1 */
    double power[HATCH_SEED_RINGS]; /* mean of the power spectrum at a radius; 1 for random points */
    bool complete;                  /* false: astray, discrepancy and power were not measured */
};

/* Measures a seed set, in quadratic time up to HATCH_SEED_FIGURES_MAX seed points.
 *   throws  random sets for distance_random, at least 1 */
enum hatch_status hatch_measure_seeds(const struct hatch_seed_set *set, uint32_t throws, struct hatch_arena *scratch,
                                      struct hatch_seed_figures *figures, struct hatch_err *err) HATCH_MUST_USE;

#endif
