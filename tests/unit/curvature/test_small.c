/* Supports, and the curvature from the smallest of them. */
#include "curvature_make.h"
#include "curvature/work.h"

static struct hatch_curvature_options adaptive;

static void begin_run(const struct field_case *of, struct hatch_curvature_run *run)
{
    *run = (struct hatch_curvature_run){.frames = &of->frames, .options = &adaptive, .workers = 1};
    HATCH_TEST_OK(hatch_curvature_graph_make(&of->surface, &of->frames, &keep, &run->graph, &err), &err);
    run->supports = HATCH_NEW(&keep, struct hatch_support, 1, &err);
    ck_assert_ptr_nonnull(run->supports);
    HATCH_TEST_OK(hatch_support_make(&run->graph.surface, run->graph.normals, &keep, run->supports, &err), &err);
}

START_TEST(a_support_holds_the_points_within_its_radius)
{
    struct field_case of = case_of_shape(HATCH_SHAPE_PLANE, 2000, 1);
    struct hatch_curvature_run run;
    begin_run(&of, &run);
    const struct hatch_surface *surface = &run.graph.surface;
    const struct hatch_support *support = run.supports;
    for (uint32_t center = 0; center < surface->point_count; center += 17) {
        const double radius = 4.3, *origin = &surface->points[3 * (size_t)center];
        uint32_t want = 0;
        ck_assert(!hatch_support_gather(run.supports, center, &run.graph.normals[3 * (size_t)center], radius));
        for (uint32_t p = 0; p < surface->point_count; p++)
            want += hatch_vec_distance(&surface->points[3 * (size_t)p], origin) <= radius;
        ck_assert_uint_eq(support->count, want);
        ck_assert_uint_eq(support->points[0], center);
        for (uint32_t i = 0; i < support->count; i++) {
            const double *at = &surface->points[3 * (size_t)support->points[i]];
            ck_assert_double_le(hatch_vec_distance(at, origin), radius);
            for (int k = 0; k < 3; k++)
                ck_assert_double_eq(support->offsets[k][i], at[k] - origin[k]);
            ck_assert_int_eq(support->sides[i], 1);
        }
    }
}
END_TEST

/* The points of a fan all lie within twice its edges. */
START_TEST(a_support_of_many_points_is_limited)
{
    struct field_case of = case_of(fan(2000));
    struct hatch_curvature_run run;
    begin_run(&of, &run);
    const struct hatch_surface *surface = &run.graph.surface;
    uint32_t hub = 0;
    for (uint32_t p = 0; p < surface->point_count; p++)
        if (surface->ring_first[p + 1] - surface->ring_first[p] > 100)
            hub = p;
    const double radius = 5.3;
    ck_assert(hatch_support_gather(run.supports, hub, &run.graph.normals[3 * (size_t)hub], radius));
    ck_assert_uint_eq(run.supports->count, (uint32_t)ceil(200 + 16 * radius * radius));
}
END_TEST

/* A flat strip from a point on, with the next points at distances that are powers of 1.25. */
static struct hatch_mesh strip(uint32_t points)
{
    struct hatch_mesh mesh;
    HATCH_TEST_OK(hatch_mesh_make(&keep, points, points - 2, &mesh, &err), &err);
    for (uint32_t i = 1; i < points; i++) {
        double away = pow(1.25, i), angle = (i % 2 ? 0.2 : -0.2) * (1 + 0.1 * i);
        mesh.attributes[0].data[3 * i] = (float)(away * cos(angle));
        mesh.attributes[0].data[3 * i + 1] = (float)(away * sin(angle));
    }
    for (uint32_t i = 0; i < 3 * mesh.face_count; i++)
        mesh.indices[i] = i / 3 + i % 3;
    return mesh;
}

/* Supports grow twelve times by 1.25. From two points of the strip on, each has one point more, so that the last has
 * 13, fewer than the 21 that a fit of degree 4 takes. If the strip has no more than 8, these have a fit of degree 2.
 */
START_TEST(supports_that_go_on_growing_have_no_fit)
{
    for (uint32_t points = 8; points <= 30; points += 22) {
        struct field_case of = case_of(strip(points));
        struct hatch_curvature_run run;
        begin_run(&of, &run);
        const struct hatch_surface *surface = &run.graph.surface;
        struct hatch_jet_frame frame = {.radius = 0};
        struct hatch_jet_system system = {.degree = 9};
        uint32_t end = 0;
        for (uint32_t p = 0; p < points; p++)
            end = surface->points[3 * p] < surface->points[3 * end] ? p : end;
        double radius = pow(1.25, 1.5) / surface->components[0].scale;
        hatch_curvature_fit(run.supports, end, &run.graph.normals[3 * (size_t)end], radius, 4, &frame, &system);
        ck_assert_uint_eq(run.supports->count, points == 8 ? 8 : 13);
        ck_assert_double_eq_tol(frame.radius, points == 8 ? radius * pow(1.25, 7) : 0, 1e-9);
        ck_assert_uint_eq(system.degree, points == 8 ? 2 : 0);
    }
}
END_TEST

/* Half the last place of a float at the largest coordinate, whichever that is. */
START_TEST(rounding_errors_grow_with_the_largest_coordinate)
{
    for (uint32_t k = 0; k < 3; k++) {
        struct field_case near = case_of_shape(HATCH_SHAPE_PLANE, 200, 1);
        for (uint32_t v = 0; v < near.mesh.vertex_count; v++)
            near.mesh.attributes[0].data[3 * v + k] += 1000;
        struct field_case far = case_of(near.mesh);
        for (uint32_t p = 0; p < far.surface.point_count; p++) {
            double at[3], error = hatch_curvature_rounding_error(&far.surface, p);
            hatch_surface_position(&far.surface, p, at);
            ck_assert_double_eq_tol(error * far.surface.components[0].scale / (at[k] * 0x1p-25), 1, 1e-6);
        }
    }
}
END_TEST

/* On planes and spheres no direction is certain, so that points take the mean of the fits around. */
START_TEST(means_of_fits_have_the_curvature_of_the_shape)
{
    static const enum hatch_shape shapes[] = {HATCH_SHAPE_PLANE, HATCH_SHAPE_SPHERE};
    for (int i = 0; i < 2; i++) {
        struct field_case of = case_with_truth(shapes[i], 5000, 0);
        struct hatch_curvature_run run;
        begin_run(&of, &run);
        uint32_t points = of.surface.point_count;
        struct hatch_curvature_sample *samples = HATCH_NEW(&keep, struct hatch_curvature_sample, points, &err);
        double *noise = HATCH_NEW(&keep, double, points, &err), curvature = i ? 1 : 0;
        ck_assert(samples && noise);
        HATCH_TEST_OK(hatch_curvature_fit_small(&run, &scratch, samples, noise, &err), &err);
        double scale = of.surface.components[0].scale;
        for (uint32_t p = 0; p < points; p++) {
            const struct hatch_curvature_tensor *tensor = &samples[p].tensor;
            double at[3];
            hatch_vec_copy(&run.graph.surface.points[3 * (size_t)p], at);
            hatch_vec_normalize(at);
            ck_assert_double_gt(i ? hatch_vec_dot(tensor->normal, at) : fabs(tensor->normal[2]), 0.99999);
            for (int row = 0, entry = 0; row < 3; row++)
                for (int column = row; column < 3; column++, entry++) {
                    double want = curvature * ((row == column) - tensor->normal[row] * tensor->normal[column]);
                    ck_assert_double_eq_tol(tensor->matrix[entry] / scale, want, 0.01);
                }
            ck_assert(samples[p].variance.off_diagonal >= 0 && samples[p].variance.off_diagonal < INFINITY);
            ck_assert_double_ge(samples[p].radius, HATCH_CURVATURE_RADIUS_MIN - 1e-9);
            ck_assert_double_le(samples[p].radius, 2 * HATCH_CURVATURE_RADIUS_MIN);
            ck_assert_double_lt(sqrt(noise[p]), 1e-3);
        }
    }
}
END_TEST

/* Normals at the corners of tetrahedra turn away from each other, so that each point is covered by a fit of its own
 * alone, which one point does not determine. */
START_TEST(each_point_may_have_its_own_fit)
{
    enum { POINTS = 16 };
    static const uint32_t corners[12] = {0, 1, 2, 0, 3, 1, 0, 2, 3, 1, 3, 2};
    float positions[3 * POINTS];
    uint32_t indices[3 * POINTS];
    for (uint32_t i = 0; i < 3 * POINTS; i++) { /* every other corner of cubes, 10 apart */
        uint32_t point = i / 3, axis = i % 3, bits = point % 4;
        bool up = axis < 2 ? bits >> axis & 1 : (bits ^ bits >> 1) & 1;
        positions[i] = (up ? 1 : -1) + (axis == 0 ? 10 * (float)(point / 4) : 0);
        indices[i] = i / 12 * 4 + corners[i % 12];
    }
    struct field_case of = case_of(mesh_of(positions, POINTS, indices, POINTS));
    struct hatch_curvature_run run;
    struct hatch_curvature_sample samples[POINTS];
    double noise[POINTS];
    begin_run(&of, &run);
    HATCH_TEST_OK(hatch_curvature_fit_small(&run, &scratch, samples, noise, &err), &err);
    for (uint32_t p = 0; p < POINTS; p++) {
        ck_assert(!hatch_support_gather(run.supports, p, &run.graph.normals[3 * (size_t)p], 1.3));
        ck_assert_uint_eq(run.supports->count, 1);
        ck_assert(samples[p].variance.mean == INFINITY && samples[p].variance.off_diagonal == INFINITY);
        ck_assert_double_eq(samples[p].radius, HATCH_CURVATURE_RADIUS_MIN);
    }
}
END_TEST

enum { BOWL_SIDE = 13, BOWL_MIDDLE = BOWL_SIDE / 2 };
static const double bowl = 1e-5; /* height at radius 1 */

/* The bowl z = bowl r⁴ over a square grid. */
static struct hatch_mesh make_bowl(void)
{
    struct hatch_mesh mesh;
    HATCH_TEST_OK(hatch_mesh_make(&keep, BOWL_SIDE * BOWL_SIDE, 2 * (BOWL_SIDE - 1) * (BOWL_SIDE - 1), &mesh, &err),
                  &err);
    uint32_t *corner = mesh.indices;
    for (uint32_t i = 0; i < BOWL_SIDE * BOWL_SIDE; i++) {
        float *at = &mesh.attributes[0].data[3 * i];
        at[0] = (float)(i % BOWL_SIDE) - BOWL_MIDDLE;
        at[1] = (float)(i / BOWL_SIDE) - BOWL_MIDDLE;
        float square = at[0] * at[0] + at[1] * at[1];
        at[2] = (float)bowl * square * square;
        if (i % BOWL_SIDE == BOWL_SIDE - 1 || i / BOWL_SIDE == BOWL_SIDE - 1)
            continue;
        const uint32_t faces[6] = {i, i + 1, i + BOWL_SIDE + 1, i, i + BOWL_SIDE + 1, i + BOWL_SIDE};
        memcpy(corner, faces, sizeof faces);
        corner += 6;
    }
    return mesh;
}

/* The middle of the bowl is flat. A quadric that is fitted to the 25 points around it has the curvature
 * 2 cov(r⁴, r²) / var(r²) = 2 · 1180 / 140 times bowl; a quartic is exact. No direction is certain there, so that
 * the middle takes the mean of the fits around. */
START_TEST(means_are_of_fits_of_the_degree_given)
{
    struct field_case of = case_of(make_bowl());
    struct hatch_curvature_run run;
    struct hatch_curvature_sample samples[BOWL_SIDE * BOWL_SIDE];
    double noise[2][BOWL_SIDE * BOWL_SIDE];
    begin_run(&of, &run);
    for (uint32_t degree = 2; degree <= 4; degree += 2) {
        const struct hatch_curvature_options options = {.degree = degree};
        const double *m, quadric = 2 * 1180.0 / 140 * bowl, want = degree == 2 ? quadric : 0;
        uint32_t middle = 0;
        run.options = &options;
        HATCH_TEST_OK(hatch_curvature_fit_small(&run, &scratch, samples, noise[degree / 4], &err), &err);
        for (uint32_t p = 0; p < BOWL_SIDE * BOWL_SIDE; p++)
            if (run.graph.surface.points[3 * p + 2] < run.graph.surface.points[3 * middle + 2])
                middle = p;
        m = samples[middle].tensor.matrix;
        double mean = fabs(m[0] + m[3] + m[5]) / 2 / of.surface.components[0].scale;
        ck_assert_msg(fabs(mean - want) < 0.3 * quadric, "degree %u: %g instead of %g", degree, mean, want);
    }
    ck_assert_mem_eq(noise[0], noise[1], sizeof noise[0]); /* which quartics measure */
}
END_TEST

static Suite *suite(void)
{
    Suite *suite = suite_create("small supports");
    TCase *tests = tcase_create("small");
    tcase_add_checked_fixture(tests, begin, end);
    tcase_add_test(tests, a_support_holds_the_points_within_its_radius);
    tcase_add_test(tests, a_support_of_many_points_is_limited);
    tcase_add_test(tests, supports_that_go_on_growing_have_no_fit);
    tcase_add_test(tests, rounding_errors_grow_with_the_largest_coordinate);
    tcase_add_test(tests, means_of_fits_have_the_curvature_of_the_shape);
    tcase_add_test(tests, each_point_may_have_its_own_fit);
    tcase_add_test(tests, means_are_of_fits_of_the_degree_given);
    suite_add_tcase(suite, tests);
    return suite;
}
HATCH_TEST_MAIN(suite)
