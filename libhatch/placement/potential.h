/* The potential field: how dark it is around each place, over every level that a stroke would reach and
 * over every scale, so that a candidate's goodness is a mean along one line. Private to tam.
 *
 * Praun et al. 2001, §4, sum the darkness that a stroke adds over all receiving levels and over all
 * levels of each one's pyramid. That sum is linear in the paper that is left: it is the integral, over
 * the stroke, of the sum of all those pyramids. The field keeps this sum on one grid, with smooth
 * pyramids in place of box filters (their blocks would draw strokes to block borders), so that a
 * candidate costs some dozens of look-ups instead of its footprints on all levels and pyramids.
 */
#ifndef HATCH_TAM_POTENTIAL_H
#define HATCH_TAM_POTENTIAL_H

#include "placement/canvas.h"

#define HATCH_POTENTIAL_OCTAVES_MAX 12u
#define HATCH_POTENTIAL_PARTS 64u

struct hatch_potential {
    uint32_t size; /* cells each way, a power of two */
    uint32_t octaves;
    float *potential; /* size² cells */
    float *share;     /* of the ink: [n * (n - 1) / 2 + i] is in part i of n along the stroke, n = 1 ..
                         HATCH_POTENTIAL_PARTS; the shares of one n sum to 1 */
    float *octave[HATCH_POTENTIAL_OCTAVES_MAX]; /* work: what was deposited since, at each scale */
    bool *used;                                 /* rows of octave[0] that hold something */
    float *row;                                 /* work: one row and a cell on either side */
    uint32_t canvas_size_px, levels;
    uint32_t reach;                        /* the potential is that of levels 0 .. reach - 1 */
    float *darkness[HATCH_MIP_LEVELS_MAX]; /* of each canvas level, averaged over cells */
    uint32_t grid[HATCH_MIP_LEVELS_MAX];   /* its size: the field's, or the level's if smaller */
};

/* A field for a white canvas, turned to all its levels, and for strokes of that brush. canvas_size_px: a power of
 * two. */
enum hatch_status hatch_potential_make(struct hatch_arena *arena, uint32_t canvas_size_px, uint32_t levels,
                                       const struct hatch_brush *brush, struct hatch_potential *field,
                                       struct hatch_err *err) HATCH_MUST_USE;

/* Turns to strokes that levels 0 .. level receive: the potential is that of what has been deposited on
 * those levels. Costs nothing where it was the last that the field turned to. */
void hatch_potential_start(struct hatch_potential *field, uint32_t level);

/* Takes in canvas->change of the stroke just drawn on that level; what lies beyond the levels of the last
 * start shows from the next one on. */
void hatch_potential_deposit(struct hatch_potential *field, const struct hatch_canvas *canvas, uint32_t level);

/* Spreads what was deposited over all scales: once per stroke. */
void hatch_potential_settle(struct hatch_potential *field);

/* The mean potential along the stroke's centre line, weighted by where the brush holds its ink, from at
 * most samples_max evenly spaced places: the lower the better. */
float hatch_potential_score(const struct hatch_potential *field, const struct hatch_stroke *stroke,
                            uint32_t samples_max);

#endif
