/* Chooses the best of many random candidate strokes (Praun et al. 2001, §4). Private to placement. */
#ifndef HATCH_PLACEMENT_PLACE_H
#define HATCH_PLACEMENT_PLACE_H

#include "placement/canvas.h"
#include "placement/potential.h"

/* One choice among candidates. */
struct hatch_choice {
    uint64_t seed;       /* random seed */
    uint64_t number;     /* number of this choice, which selects its stream of random numbers */
    uint32_t level;      /* coarsest level that receives the stroke */
    uint32_t candidates; /* number of candidates */
    float length_max;    /* fraction of the tile: that of the style, or less when only a little darkness is missing */
    float scale;         /* share of its full length at which the stroke is first drawn */
    float rgb[3];        /* colour of the stroke, linear */
    uint32_t direction_count;
    float directions[HATCH_STYLE_DIRECTIONS_MAX]; /* radians; candidates alternate between them */
};

/* Returns a candidate by its number, 0 upwards. */
struct hatch_stroke hatch_choice_candidate(const struct hatch_style *style, const struct hatch_choice *choice,
                                           uint32_t candidate);

/* Moves the few candidates with the lowest potential across their direction to a local minimum, and returns the one
 * that is lowest there. */
struct hatch_stroke hatch_place_by_field(const struct hatch_style *style, const struct hatch_potential *field,
                                         const struct hatch_choice *choice);

/* Returns the candidate with the largest goodness as the paper defines it: the darkness that it adds, summed over all
 * levels that receive it and all levels of their image pyramids, divided by its length.
 *   pyramids  [level][p]: reflectance of each level, box-filtered p times */
struct hatch_stroke hatch_place_exhaustively(const struct hatch_canvas *canvas, float *pyramids[][HATCH_MIP_LEVELS_MAX],
                                             const struct hatch_choice *choice);

#endif
