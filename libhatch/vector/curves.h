/* From curves in the unit scene to their visible and hidden parts in the picture. */
#ifndef HATCH_VECTOR_CURVES_H
#define HATCH_VECTOR_CURVES_H

#include "vector/occluders.h"
#include "vector/paths.h"

/* A curve. The last point of a closed one repeats its first. */
struct hatch_vector_curve {
    uint32_t first, count; /* range of points */
    uint32_t layer;        /* pen or tone that draws it, from 0 */
    uint32_t id;           /* kept by all its parts */
    double reach_px;       /* it is visible where it would be if it were moved sideways by up to this much: for outlines
                              of smooth surfaces, which lie slightly before or behind the outline of the faces */
    bool closed;
};

struct hatch_vector_curves {
    uint32_t count;
    const struct hatch_vector_curve *curves;
    const double *points;   /* 3 per point, in the unit scene */
    const uint32_t *faces;  /* per point: the face it lies on, as in hatch_occluders_face, or HATCH_NONE; NULL: none */
    const float *widths_px; /* per point: the width wanted there; 0: not drawn; NULL: all is drawn */
    const float *slack; /* per point: distance along the view axis by which a surface may be nearer without hiding the
                           curve; linear between points. Below 0: the segment to the next point is hidden. NULL: 0 */
    const bool *blank;  /* per point: whether the segment from it to the next point is not drawn where it is in sight;
                           NULL: none is */
};

/* The pen that draws curves. A point is drawn where `drawn` returns at least 0; between points the result is taken as
 * linear.
 *   wanted_px  width wanted at a point */
struct hatch_vector_pen {
    double width_px;
    double (*drawn)(const struct hatch_vector_pen *pen, double wanted_px);
};

/* The usual rule: a pen draws where at least half its width is wanted. */
double hatch_vector_half_width(const struct hatch_vector_pen *pen, double wanted_px);

/* How parts are cleaned up. */
struct hatch_vector_care {
    double gap_px;   /* shorter hidden parts between visible ones are drawn */
    double speck_px; /* shorter visible parts between hidden ones are not */
};

/* Finds what the occluders leave of curves. Parts beyond the picture's borders, or before the near plane, are cut off.
 *   pen      NULL if the curves have no widths
 *   arena    for the paths; not the scratch arena
 *   visible  out: paths in the order of the curves
 *   hidden   out: the parts that occluders hide; NULL: not wanted */
enum hatch_status hatch_vector_see(const struct hatch_occluders *occluders, const struct hatch_vector_curves *curves,
                                   const struct hatch_vector_pen *pen, const struct hatch_vector_care *care,
                                   struct hatch_arena *arena, struct hatch_arena *scratch,
                                   struct hatch_vector_paths *visible, struct hatch_vector_paths *hidden,
                                   struct hatch_err *err) HATCH_MUST_USE;

#endif
