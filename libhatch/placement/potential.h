/* The potential: the darkness drawn so far around each position, summed over the levels that a stroke would reach and
 * over all scales. The score of a candidate is the mean of the potential along its centre line; lower is better.
 * Private to placement.
 *
 * Praun et al. 2001, §4, sum the darkness that a stroke adds over all these levels and over all levels of an image
 * pyramid of each. That sum is linear in the reflectance that remains, so it is the integral over the stroke of one
 * field, the sum of the reflectance pyramids. The potential keeps such a sum on one grid, with smooth pyramids instead
 * of box filters (whose blocks would attract strokes to block borders). A candidate thus costs some dozens of look-ups
 * instead of its footprints on all levels and pyramids. */
#ifndef HATCH_PLACEMENT_POTENTIAL_H
#define HATCH_PLACEMENT_POTENTIAL_H

#include "placement/canvas.h"

#define HATCH_POTENTIAL_OCTAVES_MAX 12u
#define HATCH_POTENTIAL_PARTS 64u

struct hatch_potential {
    uint32_t size;    /* width and height of the grid in cells, a power of two */
    uint32_t octaves; /* number of scales */
    float *potential; /* size² cells */
    float *share;     /* distribution of ink along a stroke: [n * (n - 1) / 2 + i] is the share in part i of n equal
                         parts, n = 1 .. HATCH_POTENTIAL_PARTS */
    float *octave[HATCH_POTENTIAL_OCTAVES_MAX]; /* scratch: darkness deposited since the last update, at each scale */
    bool *used;                                 /* per row of octave[0], whether anything was deposited on it */
    float *row;                                 /* scratch: one row and a cell on either side */
    uint32_t canvas_size_px, levels;
    uint32_t reach;                        /* the potential is that of levels 0 .. reach - 1 */
    float *darkness[HATCH_MIP_LEVELS_MAX]; /* of each canvas level, averaged over cells */
    uint32_t grid[HATCH_MIP_LEVELS_MAX];   /* width and height of darkness[level]: size, or the level's if smaller */
};

/* Makes a field for a canvas of white paper, with all its levels selected.
 *   canvas_size_px  a power of two
 *   brush           of the strokes to score
 *   field           out, in arena */
enum hatch_status hatch_potential_make(struct hatch_arena *arena, uint32_t canvas_size_px, uint32_t levels,
                                       const struct hatch_brush *brush, struct hatch_potential *field,
                                       struct hatch_err *err) HATCH_MUST_USE;

/* Makes the potential that of levels 0 .. level, which the next stroke reaches. Does nothing if these are already
 * selected. */
void hatch_potential_select(struct hatch_potential *field, uint32_t level);

/* Records canvas->change of the stroke just drawn on a level. On a level that is not selected, it takes effect once the
 * level is selected. */
void hatch_potential_deposit(struct hatch_potential *field, const struct hatch_canvas *canvas, uint32_t level);

/* Spreads the recorded changes over all scales. To be called once per stroke. */
void hatch_potential_update(struct hatch_potential *field);

/* Returns the mean potential along the centre line of a stroke (for a path, its chord), weighted by the brush's ink;
 * lower is better.
 *   samples_max  largest number of samples, which are evenly spaced */
float hatch_potential_score(const struct hatch_potential *field, const struct hatch_stroke *stroke,
                            uint32_t samples_max);

#endif
