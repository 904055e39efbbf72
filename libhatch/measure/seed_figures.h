/* The figures of a seed set; hatchstat(1) writes their formulas. */
#ifndef HATCH_MEASURE_SEED_FIGURES_H
#define HATCH_MEASURE_SEED_FIGURES_H

#include "seed/spread.h"

#define HATCH_SEED_FIGURES_MAX 8192u /* seeds; of larger sets what takes quadratic time is not measured */
#define HATCH_SEED_RINGS 4u          /* of the spectrum: at 1/4, 1/2, 3/4 and 1 times sqrt(N) */

struct hatch_seed_figures {
    uint32_t seeds;
    uint32_t uneven;                /* patterns, of all lengths, that appear more or less often than they may */
    uint32_t astray;                /* seeds whose image under zooming by two is not the next one, in exact integers */
    double distance;                /* smallest distance of two seeds over the hexagonal bound */
    double distance_sparse;         /* the same of those that remain at the next level, found by their parities */
    double distance_random;         /* the same of independent random points, mean of many throws */
    double distance_bayer;          /* the same of the first N of the recursive Bayer order */
    double discrepancy;             /* star discrepancy */
    double correlation;             /* of u and v */
    double power[HATCH_SEED_RINGS]; /* mean power at a radius of the spectrum; random points: 1 */
    bool whole;                     /* false: too many seeds, and astray, discrepancy and power are not measured */
};

/* Measures one set; time is quadratic in its seeds where they are not too many to be measured whole. throws: 1 ..,
 * sets of random points that distance_random is the mean of. */
enum hatch_status hatch_measure_seeds(const struct hatch_seed_set *set, uint32_t throws, struct hatch_arena *scratch,
                                      struct hatch_seed_figures *figures, struct hatch_err *err) HATCH_MUST_USE;

#endif
