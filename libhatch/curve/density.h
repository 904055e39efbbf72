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

#define HATCH_DENSITY_BEYOND 1000u /* one of so many points may have a threshold over the greatest density */

/* Finds the greatest density that strokes reach: a threshold that at most one point of HATCH_DENSITY_BEYOND exceeds.
 * Single points that tracing left far above all others, as beside a short end, would promise strokes that there are
 * not.
 *   thresholds  count of them, at least 1
 *   densest     out
 * HATCH_LIMIT when memory runs out. */
enum hatch_status hatch_curves_densest(const float *thresholds, uint32_t count, struct hatch_arena *scratch,
                                       float *densest, struct hatch_err *err) HATCH_MUST_USE;

#endif
