/* The marks that a stroke is drawn in. shaders/traced/marks.glsl of render-gl computes the same.
 *
 * Marks are anchored on the surface. The arc length along a stroke is divided into cells of length 2^-n, in a unit that
 * all strokes of a mesh share, with one place in each cell of each n. A cell's place is also that of one of its two
 * halves, which a hash chooses; places of coarse cells are therefore among those of finer ones, and stay where they are
 * while the scale changes. The level of a stroke at a point is the binary logarithm of the places wanted per unit
 * there. Between two whole levels, the places that the finer one adds come one after the other, so that their number
 * grows evenly with the scale.
 *
 * Marks up to HATCH_DOT_WIDTHS times as long as wide are dots, each about a place. Longer ones run from each place to
 * the next, less the gap. Dots are spread evenly in both directions: the gaps between dots grow in light tones like
 * those between strokes. */
#ifndef HATCH_CURVE_MARKS_H
#define HATCH_CURVE_MARKS_H

#include <stdbool.h>

#include "base/bytes.h"
#include "curve/width.h"

#define HATCH_DOT_WIDTHS 2.0f
#define HATCH_DOT_LAYERS 2.5 /* how often the dots of tone 1 would cover the surface if they did not overlap */

/* A point of a stroke in a picture. */
struct hatch_mark_point {
    float at;      /* arc length from the start of the stroke, in that unit */
    float scale;   /* pixels per unit along the stroke */
    float level;   /* binary logarithm of places per unit */
    float share;   /* of the dots that are drawn, 0 .. 1; longer marks are all drawn */
    float scatter; /* greatest distance of marks from the stroke's line, in pixels */
};

struct hatch_mark {
    float from, to;  /* arc lengths */
    float beside[2]; /* distance from the stroke's line at both ends, in pixels; above 0: to its left in the picture */
};

/* Returns whether the marks of a pen are dots. */
bool hatch_pen_has_dots(const struct hatch_stroke_pen *pen);

/* Returns the mean distance between places along a stroke, in pixels.
 *   tone  of the strokes, 0 .. 1 */
double hatch_mark_period_px(const struct hatch_stroke_pen *pen, double tone);

/* Returns the tone of whole strokes whose marks have a tone: the tone itself if they are no dots. */
double hatch_mark_stroke_tone(const struct hatch_stroke_pen *pen, double tone);

/* Lists the marks of a stroke from its start to its end.
 *   stroke  random number of the stroke
 *   points  count of them, at least 2, with rising arc length from 0
 *   marks   in, out: struct hatch_mark are added
 * HATCH_LIMIT when memory runs out. */
enum hatch_status hatch_marks_list(const struct hatch_stroke_pen *pen, uint32_t stroke,
                                   const struct hatch_mark_point *points, uint32_t count, struct hatch_buffer *marks,
                                   struct hatch_err *err) HATCH_MUST_USE;

#endif
