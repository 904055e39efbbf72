/* Choosing the best of many candidate strokes (Praun et al. 2001, §4). Private to tam. */
#ifndef HATCH_TAM_PLACE_H
#define HATCH_TAM_PLACE_H

#include "placement/canvas.h"
#include "placement/potential.h"

/* What one choice starts from. */
struct hatch_choice {
    uint64_t seed, number; /* the number of this choice: the stream of its random numbers */
    uint32_t level;        /* coarsest level that receives the stroke */
    uint32_t candidates;
    float length_max; /* fraction of the tile: the style's, or less for a last, small gap */
    float scale;      /* share of its full length at which the stroke is first drawn */
    float rgb[3];     /* what it is drawn in */
    uint32_t direction_count;
    float directions[HATCH_STYLE_DIRECTIONS_MAX]; /* angles to draw from */
};

/* The candidate-th random stroke of a choice. */
struct hatch_stroke hatch_candidate(const struct hatch_style *style, const struct hatch_choice *choice,
                                    uint32_t candidate);

/* The best candidate by the field, moved to the best place near it. */
struct hatch_stroke hatch_place_by_field(const struct hatch_style *style, const struct hatch_potential *field,
                                         const struct hatch_choice *choice);

/* The best candidate by the paper's goodness, footprint by footprint: the sum over all receiving levels
 * and all levels of each one's image pyramid of the darkness that the stroke adds, over its length.
 * pyramids: of every level, box-filtered paper, [level][p]. */
struct hatch_stroke hatch_place_exhaustively(const struct hatch_canvas *canvas, float *pyramids[][HATCH_MIP_LEVELS_MAX],
                                             const struct hatch_choice *choice);

#endif
