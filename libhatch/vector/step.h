/* The nearest face at a place of the picture, and steps in depth across a line. */
#ifndef HATCH_VECTOR_STEP_H
#define HATCH_VECTOR_STEP_H

#include "vector/occluders.h"

/* Returns the face that is visible at a place of the picture, or NULL where there is none, or outside the picture.
 *   depth  out: depth of the face there, or HUGE_VAL */
const struct hatch_occluder *hatch_occluders_find(const struct hatch_occluders *occluders, const double at_px[2],
                                                  double *depth);

/* Returns the depth of the nearest surface at a place of the picture; HUGE_VAL where there is none, or outside the
 * picture. */
double hatch_occluders_depth(const struct hatch_occluders *occluders, const double at_px[2]);

/* Returns by how many pixels the surface beyond a line is farther than the line, its own slope deducted: one that
 * merely recedes is no step. HUGE_VAL where there is none. line_test.frag of render-gl, which sees depths of pixels
 * only, looks a little farther.
 *   at_px  place on the line
 *   away   unit vector in the picture, from the line to where the surface beyond it is looked for
 *   depth  of the line there */
double hatch_occluders_step(const struct hatch_occluders *occluders, const double at_px[2], const double away[2],
                            double depth);

#endif
