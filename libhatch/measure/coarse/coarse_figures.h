/* How a coarse mesh differs from the full one in a set of views; hatchstat(1) has the formulas. */
#ifndef HATCH_MEASURE_COARSE_FIGURES_H
#define HATCH_MEASURE_COARSE_FIGURES_H

#include <stdatomic.h>

#include "base/parallel.h"
#include "view/around.h"

struct hatch_coarse_figures {
    double displacement_px,
        displacement_p999_px;           /* distance of one surface from the other: largest, 99.9th percentile, which is
                                           rounded up by 1/256 pixel or, over 16 pixels, by a hundredth */
    double outline_px, outline_p999_px; /* distance of one outline from the other */
    double normal_deg;                  /* mean angle between the normals of both surfaces, where both have one */
};

/* Measures two meshes, each sampled against the other. Their positions are those in the world relative to the centre of
 * the views' bounds, so that they keep their precision far from the origin. The outlines are those of pictures in which
 * a pixel is divided into HATCH_OUTLINE_PARTS parts each way; their distances are multiples of such a part, with an
 * error of one.
 *   full, coarse  have faces
 *   worst         out: per face of full: the largest displacement on it, or of a place on the coarse mesh that is
 *                 nearest to it, in steps of a pixel / HATCH_WORST_STEPS, rounded up; outlines and normals are not
 * measured then, and are 0; NULL: not wanted */
enum hatch_status hatch_measure_coarse(const struct hatch_mesh *full, const struct hatch_mesh *coarse,
                                       const struct hatch_view_set *views, atomic_uint *worst, struct hatch_pool *pool,
                                       struct hatch_arena *scratch, struct hatch_coarse_figures *figures,
                                       struct hatch_err *err) HATCH_MUST_USE;

#define HATCH_OUTLINE_PARTS 8
#define HATCH_WORST_STEPS 1000.0

/* Measures the distances of the outlines of two meshes.
 *   figures  out: its outline figures */
enum hatch_status hatch_measure_outlines(const struct hatch_mesh *full, const struct hatch_mesh *coarse,
                                         const struct hatch_view_set *views, struct hatch_pool *pool,
                                         struct hatch_arena *scratch, struct hatch_coarse_figures *figures,
                                         struct hatch_err *err) HATCH_MUST_USE;

#endif
