/* Shapes with known principal directions, and the angles between these and estimated ones. */
#ifndef HATCH_TEST_CURVATURE_MAKE_H
#define HATCH_TEST_CURVATURE_MAKE_H

#include "field_make.h"
#include "curvature/curvature.h"

static const enum hatch_shape bent[5] = {HATCH_SHAPE_TORUS, HATCH_SHAPE_ELLIPSOID, HATCH_SHAPE_CYLINDER,
                                         HATCH_SHAPE_SADDLE, HATCH_SHAPE_WAVE};

static inline struct field_case case_with_truth(enum hatch_shape shape, uint32_t faces, float noise)
{
    const struct hatch_shape_options options = {.faces = faces, .jitter = 1, .noise = noise, .seed = 3, .field = true};
    struct hatch_mesh mesh = shape_with(shape, options);
    struct field_case of = case_of(mesh);
    const float *field = hatch_mesh_find(&mesh, "_HATCH_DIR", 4);
    for (size_t i = 0; i < 3 * (size_t)of.surface.face_count; i++) {
        uint32_t p = of.surface.corners[i];
        const float *at = &field[4 * (size_t)of.surface.corner_vertex[i]];
        hatch_vec_of(at, &of.direction[3 * (size_t)p]);
        of.confidence[p] = (double)at[3];
    }
    return of;
}

static inline struct hatch_curvature estimate_case(const struct field_case *of, double radius, uint32_t degree)
{
    struct hatch_curvature found;
    const struct hatch_curvature_options options = {.radius = radius, .degree = degree};
    HATCH_TEST_OK(hatch_curvature_estimate(&of->surface, &of->frames, &options, &keep, &scratch, &found, &err), &err);
    return found;
}

static inline double degrees_apart(const double *a, const double *b)
{
    double across[3];
    hatch_vec_cross(a, b, across);
    return atan2(hatch_vec_length(across), fabs(hatch_vec_dot(a, b))) * 180 / PI;
}

struct angles {
    double *degrees;
    uint32_t count;
};

static inline int by_size(const void *a, const void *b)
{
    double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

/* Adds the angles between a field and the known directions at all points that have one.
 *   border  true: only at border points */
static inline void add_angles(struct angles *angles, const struct field_case *of, const double *direction, bool border)
{
    double *more = HATCH_NEW(&keep, double, (size_t)angles->count + of->surface.point_count, &err);
    ck_assert_ptr_nonnull(more);
    if (angles->count)
        memcpy(more, angles->degrees, angles->count * sizeof *more);
    angles->degrees = more;
    for (uint32_t p = 0; p < of->surface.point_count; p++) {
        bool open = of->surface.ring_face[of->surface.ring_first[p + 1] - 1] == HATCH_NO_SIDE;
        if (of->confidence[p] > 0 && (open || !border))
            more[angles->count++] = degrees_apart(&direction[3 * (size_t)p], &of->direction[3 * (size_t)p]);
    }
}

static inline double percentile(struct angles *angles, double share)
{
    ck_assert_uint_gt(angles->count, 0);
    qsort(angles->degrees, angles->count, sizeof *angles->degrees, by_size);
    return angles->degrees[(uint32_t)(share * (angles->count - 1))];
}

#endif
