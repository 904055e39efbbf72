/* Makes the density of strokes exactly what their thresholds say. */
#ifndef HATCH_CURVE_DENSITY_H
#define HATCH_CURVE_DENSITY_H

#include "curve/curves.h"

#define HATCH_DENSITY_MOST 2.0 /* greatest factor of a change */

/* Computes thresholds for which, on the mean of the mesh, strokes of length x per unit of area have thresholds under x,
 * in each family. The order of thresholds is kept. Those from tracing are off by up to a quarter, because levels fill
 * gaps one after the other.
 *   thresholds  in, out: one per point of curves; each changes by a factor HATCH_DENSITY_MOST at most
 * HATCH_LIMIT when memory runs out. */
enum hatch_status hatch_curves_even_thresholds(const struct hatch_curves *curves, const struct hatch_mesh *mesh,
                                               struct hatch_arena *scratch, float *thresholds,
                                               struct hatch_err *err) HATCH_MUST_USE;

#endif
