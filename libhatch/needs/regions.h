/* Regions of a scene at rest: the box around it, divided into cells of equal size, and how large each is in the
 * pictures. They do not depend on how the surfaces are divided into faces and meshes. */
#ifndef HATCH_NEEDS_REGIONS_H
#define HATCH_NEEDS_REGIONS_H

#include <stdbool.h>
#include <stdint.h>

#define HATCH_NEEDS_SIDE 32u /* cells along each axis */
#define HATCH_NEEDS_CELLS (HATCH_NEEDS_SIDE * HATCH_NEEDS_SIDE * HATCH_NEEDS_SIDE)

/* Cell x, y, z has the index (z * HATCH_NEEDS_SIDE + y) * HATCH_NEEDS_SIDE + x. */
struct hatch_needs_regions {
    double low[3];  /* corner of the box, in world coordinates at rest */
    double side[3]; /* sides of a cell; 0 where the scene has no extent */
    float *px;      /* per cell: most pixels that a unit of the scene's lengths at rest covers there; 0: not seen */
};

/* Raises all cells that the box around a face touches to px. Places outside of the box count to its outermost cells.
 *   corners  in world coordinates at rest */
void hatch_needs_raise(struct hatch_needs_regions *regions, const double corners[3][3], double px);

/* Returns the largest px of the cells that the box around a face touches. */
double hatch_needs_px(const struct hatch_needs_regions *regions, const double corners[3][3]);

/* Raises each cell to the largest of its neighbours and itself, so that surfaces that are a little different, and views
 * between those that were measured, find what they need.
 *   work  HATCH_NEEDS_CELLS floats */
void hatch_needs_spread(struct hatch_needs_regions *regions, float *work);

#endif
