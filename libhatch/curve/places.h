/* Makes the ink of strokes the same at all places of a mesh. */
#ifndef HATCH_CURVE_PLACES_H
#define HATCH_CURVE_PLACES_H

#include "base/parallel.h"
#include "curve/curves.h"

/* Corrects thresholds by the ink that the strokes of each family make, under the law of curve/width.h, in cells a few
 * gaps wide: where it is less than elsewhere, as where many strokes end, thresholds are lowered, and raised where it is
 * more. Each level has cells of its own size.
 *   pool        NULL: one thread; the result is the same for any number
 *   thresholds  in, out: one per point of curves; each changes by a factor 1.5 at most
 * HATCH_LIMIT when memory runs out. */
enum hatch_status hatch_curves_even_places(const struct hatch_curves *curves, const struct hatch_mesh *mesh,
                                           struct hatch_pool *pool, struct hatch_arena *scratch, float *thresholds,
                                           struct hatch_err *err) HATCH_MUST_USE;

#endif
