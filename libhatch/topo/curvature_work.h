/* Private to the curvature: what its methods share. */
#ifndef HATCH_TOPO_CURVATURE_WORK_H
#define HATCH_TOPO_CURVATURE_WORK_H

#include "topo/curvature.h"

/* Zeroed, from arena. */
enum hatch_status hatch_curvature_allocate(uint32_t points, struct hatch_arena *arena,
                                           struct hatch_curvature *curvature, struct hatch_err *err)
    HATCH_MUST_USE;

#endif
