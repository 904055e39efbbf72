/* Surfaces with fields, and the angle between two fields. */
#ifndef HATCH_TEST_FIELD_MAKE_H
#define HATCH_TEST_FIELD_MAKE_H

#include <math.h>
#include <string.h>

#include "base/random.h"
#include "math/vector.h"
#include "meshes.h"
#include "field/field.h"

struct field_case {
    struct hatch_mesh mesh;
    struct hatch_surface surface;
    struct hatch_frames frames;
    double *direction, *confidence; /* per point: given directions, to which a field is fitted */
};

static inline struct field_case case_of(struct hatch_mesh mesh)
{
    struct field_case made = {.mesh = mesh};
    struct hatch_surface_notes notes = {0};
    HATCH_TEST_OK(hatch_surface_make(&mesh, &keep, &scratch, &made.surface, &notes, &err), &err);
    HATCH_TEST_OK(hatch_frames_make(&made.surface, &keep, &scratch, &made.frames, &err), &err);
    made.direction = HATCH_NEW(&keep, double, (size_t)made.surface.point_count * 3, &err);
    made.confidence = HATCH_NEW(&keep, double, made.surface.point_count, &err);
    ck_assert_ptr_nonnull(made.confidence);
    return made;
}

static inline struct field_case case_of_shape(enum hatch_shape shape, uint32_t faces, float jitter)
{
    struct hatch_mesh mesh =
        shape_with(shape, (struct hatch_shape_options){.faces = faces, .jitter = jitter, .seed = 1});
    mesh.attribute_count = 1;
    return case_of(mesh);
}

/* Sets the field to a direction in space, projected onto the surface. */
static inline void set_direction(struct field_case *field, double x, double y, double z)
{
    for (uint32_t p = 0; p < field->surface.point_count; p++) {
        const double *normal = &field->frames.normal[3 * p];
        double d[3] = {x, y, z}, along = hatch_vec_dot(d, normal);
        hatch_vec_add_scaled(d, -along, normal, d);
        if (hatch_vec_normalize(d) < 1e-6)
            hatch_vec_copy(&field->frames.axis[3 * p], d);
        hatch_vec_copy(d, &field->direction[3 * p]);
        field->confidence[p] = 1;
    }
}

/* Sets direction and confidence to the known principal directions of a shape, with noise.
 *   noise_rad   standard deviation of the normally distributed angle
 *   confidence  at points where a direction is known; 0 elsewhere */
static inline void follow_truth(struct field_case *of, enum hatch_shape shape, double noise_rad, double confidence)
{
    for (size_t i = 0; i < 3 * (size_t)of->surface.face_count; i++) {
        uint32_t p = of->surface.corners[i];
        double place[3], normal[3], line[3] = {0, 0, 0}, bends[2];
        hatch_vec_of(&of->mesh.attributes[0].data[3 * (size_t)of->surface.corner_vertex[i]], place);
        bool known = hatch_shape_curvature(shape, place, normal, line, bends);
        double u = 1 - (double)hatch_random_unit(1, 1, p), v = (double)hatch_random_unit(1, 2, p);
        double angle = hatch_frames_angle(&of->frames, p, line) + noise_rad * sqrt(-2 * log(u)) * cos(2 * PI * v);
        hatch_frames_direction(&of->frames, p, angle, &of->direction[(size_t)p * 3]);
        of->confidence[p] = known ? confidence : 0;
    }
}

static inline struct hatch_field solve_case(const struct field_case *of, enum hatch_field_method method,
                                            enum hatch_field_solver solver, double smooth)
{
    struct hatch_field field;
    const struct hatch_field_problem problem = {&of->surface, &of->frames, of->direction, of->confidence, NULL, false};
    const struct hatch_field_options options = {method, solver, smooth, 1e-8, 2000};
    HATCH_TEST_OK(hatch_field_solve(&problem, &options, &keep, &scratch, &field, &err), &err);
    return field;
}

static inline struct hatch_singularities singularities_of(const struct field_case *of, const double *direction)
{
    struct hatch_singularities found;
    HATCH_TEST_OK(hatch_field_singularities(&of->surface, &of->frames, direction, &keep, &scratch, &found, &err), &err);
    return found;
}

/* Returns the angle between two directions at a point, in its tangent plane, 0 .. π/2. */
static inline double line_angle(const struct field_case *of, uint32_t p, const double *a, const double *b)
{
    return fabs(remainder(hatch_frames_angle(&of->frames, p, a) - hatch_frames_angle(&of->frames, p, b), PI));
}

static inline double largest_angle(const struct field_case *of, const double *a, const double *b)
{
    double most = 0;
    for (uint32_t p = 0; p < of->surface.point_count; p++)
        most = fmax(most, line_angle(of, p, &a[(size_t)p * 3], &b[(size_t)p * 3]));
    return most;
}

#endif
