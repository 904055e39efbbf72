/* Lists occluders by the cells of a grid. Part of hatch_occluders_make. */
#ifndef HATCH_VECTOR_GRID_H
#define HATCH_VECTOR_GRID_H

#include "vector/occluders.h"

/* Chooses the cells of the grid and lists the occluders that reach into each: sets the members from `cells` on.
 *   arena  for the lists; not the scratch arena */
enum hatch_status hatch_occluders_list(struct hatch_occluders *occluders, struct hatch_arena *arena,
                                       struct hatch_arena *scratch, struct hatch_err *err) HATCH_MUST_USE;

#endif
