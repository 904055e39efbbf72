/* Strokes traced on a surface along a direction field, nested by density.
 *
 * A stroke is a curve on the surface at a constant angle to the field. The strokes of one angle are a family. Level by
 * level, strokes fill the gaps that those of the levels before leave: level l ends with gaps of about gap / 2^l. Each
 * point of a stroke has a threshold: where the strokes that are wanted, per unit of length across them, are fewer, it
 * is not drawn. The threshold follows from the gaps beside the point, so that of converging strokes some end by
 * themselves. The strokes of a lighter tone are among those of any darker one, and those of a coarser scale among those
 * of any finer one (Praun et al., "Real-Time Hatching", 2001, §3), on the surface itself: there is no parametrization.
 *
 * Spacing follows Jobard & Lefer ("Creating evenly-spaced streamlines of arbitrary density", 1997). Gaps are measured
 * on the surface, along geodesics across the strokes, so that other sheets of a thin surface do not count. Nothing
 * depends on an order: candidates are thinned by hashed priorities, all strokes of a round grow in lock step, and each
 * is tested against what earlier steps have drawn. Every random number is a hash of the stroke or face that it belongs
 * to. */
#ifndef HATCH_TRACE_TRACE_H
#define HATCH_TRACE_TRACE_H

#include "base/parallel.h"
#include "base/progress.h"
#include "curve/curves.h"
#include "surface/frames.h"

struct hatch_trace_options {
    uint32_t family_count;  /* 1 .. HATCH_CURVE_FAMILIES_MAX */
    const float *angle_rad; /* per family: from the field to the strokes, counter-clockwise seen from outside */
    double gap;             /* gap between the strokes of level 0, in mesh units, greater than 0 */
    uint32_t levels;        /* 1 .. HATCH_CURVE_LEVELS_MAX */
    double length;          /* greatest length of a stroke, in gaps of its level, over 1; each has .5 to 1 of it */
    double hard_rad;        /* strokes end at edges with a larger angle between the faces */
    uint64_t seed;
    const struct hatch_progress *progress; /* NULL: nobody is told */
};

/* Traces the strokes of a mesh.
 *   mesh       that the surface was made from
 *   direction  3 per point of the surface: the field; the sign is arbitrary
 *   pool       NULL: one thread; the result is the same for any number
 *   curves     out: in arena; a set for each family and level
 * HATCH_LIMIT when memory runs out. */
enum hatch_status hatch_trace_make(const struct hatch_surface *surface, const struct hatch_mesh *mesh,
                                   const struct hatch_frames *frames, const double *direction,
                                   const struct hatch_trace_options *options, struct hatch_pool *pool,
                                   struct hatch_arena *arena, struct hatch_arena *scratch, struct hatch_curves *curves,
                                   struct hatch_err *err) HATCH_MUST_USE;

#endif
