/* Makes the density of strokes exactly what their thresholds say. */
#ifndef HATCH_CURVE_DENSITY_H
#define HATCH_CURVE_DENSITY_H

#include "curve/curves.h"

#define HATCH_DENSITY_MOST 2.0 /* greatest factor of a change */

/* Groups of faces whose densities are compared: the connected components of a mesh, and as one group all components
 * that have few strokes. Zeroed, but for count 1: all faces are one group. */
struct hatch_curve_groups {
    uint32_t count;
    uint32_t *of_face; /* NULL: all faces are in group 0 */
    double *area;      /* per group, in mesh units squared */
};

#define HATCH_DENSITY_FEW 32u /* strokes of all families: components with fewer are in group 0 */

/* Groups the faces of a mesh.
 *   groups  out: arrays in arena
 * HATCH_LIMIT when memory runs out. */
enum hatch_status hatch_curves_group(const struct hatch_curves *curves, const struct hatch_mesh *mesh,
                                     struct hatch_arena *arena, struct hatch_arena *scratch,
                                     struct hatch_curve_groups *groups, struct hatch_err *err) HATCH_MUST_USE;

/* Returns the group of a point. */
uint32_t hatch_curves_group_of(const struct hatch_curve_groups *groups, const struct hatch_curve_point *point);

/* Computes thresholds for which, on the mean of each group, strokes of length x per unit of area have thresholds under
 * x, in each family. The order of the thresholds of a group is kept. Those from tracing are off by up to a quarter,
 * because levels fill gaps one after the other; and components that are narrower than coarse gaps have no coarse
 * strokes.
 *   groups      with areas
 *   thresholds  in, out: one per point of curves; each changes by a factor HATCH_DENSITY_MOST at most
 * HATCH_LIMIT when memory runs out. */
enum hatch_status hatch_curves_even_thresholds(const struct hatch_curves *curves, const struct hatch_mesh *mesh,
                                               const struct hatch_curve_groups *groups, struct hatch_arena *scratch,
                                               float *thresholds, struct hatch_err *err) HATCH_MUST_USE;

#define HATCH_DENSITY_BEYOND 1000u /* one of so many points may have a threshold over the greatest density */

/* Finds the greatest density that strokes reach in each group: a threshold that at most one point of
 * HATCH_DENSITY_BEYOND exceeds. Single points that tracing left far above all others, as beside a short end, would
 * promise strokes that there are not.
 *   thresholds  one per point of curves
 *   densest     out: per group; 0 where it has no points
 * HATCH_LIMIT when memory runs out. */
enum hatch_status hatch_curves_densest(const struct hatch_curves *curves, const struct hatch_curve_groups *groups,
                                       const float *thresholds, struct hatch_arena *scratch, float *densest,
                                       struct hatch_err *err) HATCH_MUST_USE;

#endif
