/* Private to the curvature: the support of a fit. */
#ifndef HATCH_CURVATURE_SUPPORT_H
#define HATCH_CURVATURE_SUPPORT_H

#include "curvature/jet.h"
#include "surface/surface.h"

/* The support gathered last, and the working memory of one thread. */
struct hatch_support {
    const struct hatch_surface *surface;
    const double *normals;    /* 3 per point: unit, on the outside of its ring */
    const double *weights;    /* per point, in sums; NULL: 1 each */
    double normal_cosine_min; /* of the angle between the normals of a point and of the center */
    uint32_t *visited;        /* per point: number of the last walk that reached it */
    uint32_t walk;            /* number of the current walk */
    uint32_t count;
    bool cut;           /* it ends at the radius: points beyond were reached whose normals satisfy normal_cosine_min */
    uint32_t *points;   /* of the support, in breadth-first order; the first is the center */
    int8_t *sides;      /* per entry of points: -1 where the point's outside is not that of the center, else 1 */
    double *offsets[3]; /* x, y, z per entry of points: from the center */
};

/* Returns the memory of a support, in bytes. */
size_t hatch_support_bytes(uint32_t point_count);

/* Makes an empty support; arrays in arena, surface and normals kept by reference. */
enum hatch_status hatch_support_make(const struct hatch_surface *surface, const double *normals,
                                     struct hatch_arena *arena, struct hatch_support *support,
                                     struct hatch_err *err) HATCH_MUST_USE;

/* Replaces the surface by one of no more points.
 *   weights  per point, or NULL */
void hatch_support_set_surface(struct hatch_support *support, const struct hatch_surface *surface,
                               const double *normals, const double *weights);

/* Gathers the points within a straight-line distance that are reached from the center over edges through points of
 * the support, and whose normals satisfy normal_cosine_min: the walk does not jump to the far side of a thin part.
 * Returns true when the mesh has far more points there than even edges would give: then only the nearest are taken.
 *   radius  in surface units, 0 .. INFINITY */
bool hatch_support_gather(struct hatch_support *support, uint32_t center, const double normal[3], double radius);

/* Computes the frame at the center of the support, and the sums of its points in that frame.
 *   normal  unit; the third axis */
void hatch_support_sums(const struct hatch_support *support, const double normal[3], double radius,
                        struct hatch_jet_frame *frame, struct hatch_jet_sums *sums);

#endif
