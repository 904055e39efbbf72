/* Private to the curvature: the points around a point, and a fit through them. */
#ifndef HATCH_TOPO_CURVATURE_SUPPORT_H
#define HATCH_TOPO_CURVATURE_SUPPORT_H

#include "curvature/jet.h"
#include "surface/surface.h"

/* What one thread needs to walk over a surface. normals: 3 a point, each for the side that its ring takes
 * for outside; lean_cosine: of the angle by which normals may lean away from the middle's. */
struct hatch_support {
    const struct hatch_surface *surface;
    const double *normals;
    const double *weights; /* per point, or NULL: 1 each */
    double lean_cosine;
    uint32_t *seen; /* per point: the number of the last walk that met it */
    uint32_t walk;
    uint32_t count;
    uint32_t *points;   /* those taken, nearest rings first; the first is the middle */
    int8_t *sides;      /* 1, or -1 where the point's outside is not that of the middle */
    double *offsets[3]; /* x, y, z: from the middle */
};

/* surface and normals stay the caller's. */
enum hatch_status hatch_support_make(const struct hatch_surface *surface, const double *normals,
                                     struct hatch_arena *arena, struct hatch_support *support,
                                     struct hatch_err *err) HATCH_MUST_USE;

/* Goes on to a surface of no more points. weights: how much each counts in sums, or NULL. */
void hatch_support_move(struct hatch_support *support, const struct hatch_surface *surface, const double *normals,
                        const double *weights);

/* Walks from a point over edges to all points within a radius (a straight line, 0 .. ∞) whose normals do not
 * lean away from the given one by more than lean_cosine allows (78° at first): not through the air to the
 * other side of a thin part. True when there are far more of them than even edges would give: then only the
 * nearest rings are taken. */
bool hatch_support_gather(struct hatch_support *support, uint32_t middle, const double normal[3], double radius);

/* The frame at the middle of the points gathered, and the sums of all of them in it. normal: unit. */
void hatch_support_sums(const struct hatch_support *support, const double normal[3], double radius,
                        struct hatch_jet_frame *frame, struct hatch_jet_sums *sums);

#endif
