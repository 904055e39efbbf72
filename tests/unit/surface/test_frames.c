#include "fail_alloc.h"
#include "field_make.h"

/* The ring entries of a point. */
#define FOR_RING(of, p, i) for (uint32_t i = (of)->surface.ring_first[p]; i < (of)->surface.ring_first[(p) + 1]; i++)

/* Transport along an entry and back is the identity; both ends have the same weight. */
static void check_entries(const struct field_case *of)
{
    for (uint32_t p = 0; p < of->surface.point_count; p++)
        FOR_RING(of, p, i)
        {
            uint32_t twin = of->frames.twin[i];
            bool turned = of->surface.ring_turned[i];
            double there = of->frames.transport_rad[twin] + (turned ? -0.7 : 0.7);
            double back = of->frames.transport_rad[i] + (turned ? -there : there);
            ck_assert_uint_eq(of->frames.twin[twin], i);
            ck_assert_uint_eq(of->surface.ring_point[twin], p);
            ck_assert_double_eq_tol(remainder(back - 0.7, 2 * PI), 0, 1e-12);
            ck_assert_double_gt(of->frames.weight[i], 0);
            ck_assert_double_eq(of->frames.weight[i], of->frames.weight[twin]);
        }
    for (uint32_t i = 0; i < 3 * of->surface.face_count; i++)
        ck_assert_uint_eq(of->surface.ring_face[of->frames.corner_entry[i]], i / 3);
}

static void check_planes(const struct field_case *of)
{
    for (uint32_t p = 0; p < of->surface.point_count; p++) {
        const double *normal = &of->frames.normal[3 * (size_t)p], *axis = &of->frames.axis[3 * (size_t)p];
        ck_assert_double_eq_tol(hatch_vec_length(normal), 1, 1e-12);
        ck_assert_double_eq_tol(hatch_vec_length(axis), 1, 1e-12);
        ck_assert_double_eq_tol(hatch_vec_dot(normal, axis), 0, 1e-12);
        for (int k = -3; k <= 3; k++) {
            double line[3];
            hatch_frames_direction(&of->frames, p, k, line);
            ck_assert_double_eq_tol(hatch_frames_angle(&of->frames, p, line), k, 1e-12);
        }
        ck_assert_double_eq(hatch_frames_angle(&of->frames, p, normal), 0);
    }
}

START_TEST(frames_of_every_shape_are_consistent)
{
    for (int shape = 0; shape < HATCH_SHAPE_COUNT; shape++) {
        struct field_case of = case_of_shape((enum hatch_shape)shape, 500, 1);
        check_entries(&of);
        check_planes(&of);
    }
    struct field_case mobius = case_of(band(20, 4, true)), bottle = case_of(klein(24, 12));
    ck_assert(!mobius.surface.components[0].orientable && !bottle.surface.components[0].orientable);
    check_entries(&mobius);
    check_planes(&mobius);
    check_entries(&bottle);
    check_planes(&bottle);
}
END_TEST

/* The scaled angles of all faces, less π per face, sum to 2π times the Euler characteristic (Gauss-Bonnet). */
START_TEST(scaled_angles_satisfy_gauss_bonnet)
{
    const struct field_case cases[] = {case_of_shape(HATCH_SHAPE_SPHERE, 400, 1),
                                       case_of_shape(HATCH_SHAPE_TORUS, 400, 1), case_of(klein(24, 12))};
    for (size_t k = 0; k < 3; k++) {
        const struct field_case *of = &cases[k];
        double sum = 0;
        for (uint32_t i = 0; i < 3 * of->surface.face_count; i++)
            sum += hatch_frames_corner_angle(&of->surface, &of->frames, of->surface.corners[i],
                                             of->frames.corner_entry[i]);
        ck_assert_double_eq_tol(sum - PI * of->surface.face_count, 2 * PI * of->surface.components[0].euler, 1e-8);
    }
}
END_TEST

START_TEST(transport_on_a_plane_keeps_directions)
{
    struct field_case of = case_of_shape(HATCH_SHAPE_PLANE, 300, 1);
    const double line[3] = {0.6, 0.8, 0};
    double area = 0;
    for (uint32_t p = 0; p < of.surface.point_count; p++) {
        ck_assert_double_eq_tol(of.frames.normal[3 * (size_t)p + 2], 1, 1e-9);
        area += of.frames.area[p];
        FOR_RING(&of, p, i)
        {
            double there = hatch_frames_angle(&of.frames, of.surface.ring_point[i], line);
            double turn = there + of.frames.transport_rad[i] - hatch_frames_angle(&of.frames, p, line);
            ck_assert_double_eq_tol(remainder(turn, 2 * PI), 0, 1e-6);
        }
    }
    double scale = of.surface.components[0].scale;
    ck_assert_double_eq_tol(area * scale * scale, 4, 1e-5);
}
END_TEST

/* Points of a plane are displaced in it until faces overlap: with the normal of the plane, transport still keeps a
 * direction in space, and no face has an index. */
START_TEST(transport_over_folded_faces_keeps_directions)
{
    struct hatch_mesh mesh = shape_of(HATCH_SHAPE_PLANE, 800);
    const double line[3] = {0.6, 0.8, 0};
    for (uint32_t v = 0; v < mesh.vertex_count; v++)
        for (uint32_t k = 0; k < 2; k++) {
            float *at = &mesh.attributes[0].data[3 * v];
            bool inside = fabsf(at[0]) < 0.9f && fabsf(at[1]) < 0.9f;
            at[k] += inside ? 0.1f * (hatch_random_unit(0, k, v) - 0.5f) : 0;
        }
    struct field_case of = case_of(mesh);
    double *normal = HATCH_NEW(&keep, double, 3 * (size_t)of.surface.point_count, &err);
    double *lines = HATCH_NEW(&keep, double, 3 * (size_t)of.surface.point_count, &err);
    for (size_t p = 0; p < of.surface.point_count; p++) {
        normal[3 * p + 2] = 1;
        hatch_vec_copy(line, &lines[3 * p]);
    }
    HATCH_TEST_OK(hatch_frames_set_normals(&of.surface, normal, &scratch, &of.frames, &err), &err);
    uint32_t folded = 0;
    for (uint32_t p = 0; p < of.surface.point_count; p++) {
        folded += of.frames.folded[p];
        FOR_RING(&of, p, i)
        {
            double there = hatch_frames_angle(&of.frames, of.surface.ring_point[i], line);
            double turn = there + of.frames.transport_rad[i] - hatch_frames_angle(&of.frames, p, line);
            ck_assert_double_eq_tol(remainder(turn, 2 * PI), 0, 1e-6);
        }
    }
    ck_assert_uint_gt(folded, 5);
    ck_assert_uint_eq(singularities_of(&of, lines).count, 0);
    check_entries(&of);
}
END_TEST

/* On a sphere the direction to the pole is parallel along a meridian. */
START_TEST(transport_on_a_sphere_keeps_the_meridian)
{
    struct field_case of = case_of_shape(HATCH_SHAPE_SPHERE, 4000, 0);
    uint32_t met = 0;
    for (uint32_t p = 0; p < of.surface.point_count; p++)
        FOR_RING(&of, p, i)
        {
            uint32_t q = of.surface.ring_point[i];
            const double *a = &of.surface.points[3 * (size_t)p], *b = &of.surface.points[3 * (size_t)q];
            double at[3], cross = a[0] * b[2] - a[2] * b[0];
            hatch_vec_copy(a, at);
            hatch_vec_normalize(at);
            if (fabs(at[1]) > 0.9 || fabs(cross) > 1e-3)
                continue;
            const double up[3] = {0, 1, 0};
            double turn = hatch_frames_angle(&of.frames, q, up) + of.frames.transport_rad[i] -
                          hatch_frames_angle(&of.frames, p, up);
            ck_assert_double_eq_tol(remainder(turn, 2 * PI), 0, 1e-3);
            met++;
        }
    ck_assert_uint_gt(met, 500); /* 842 were measured: edges along meridians */
}
END_TEST

/* The cotangents of a needle are 500 and -250. */
START_TEST(sliver_weights_are_positive_and_bounded)
{
    struct hatch_mesh mesh;
    const float places[4][3] = {{0, 0, 0}, {1, 0, 0}, {0.5f, 0.001f, 0}, {0.5f, -0.001f, 0}};
    const uint32_t faces[2][3] = {{0, 1, 2}, {1, 0, 3}};
    HATCH_TEST_OK(hatch_mesh_make(&keep, 4, 2, &mesh, &err), &err);
    memcpy(mesh.attributes[0].data, places, sizeof places);
    memcpy(mesh.indices, faces, sizeof faces);
    struct field_case of = case_of(mesh);
    check_entries(&of);
    check_planes(&of);
    for (uint32_t i = 0; i < of.surface.ring_first[4]; i++) {
        ck_assert_double_ge(of.frames.weight[i], 0.025);
        ck_assert_double_le(of.frames.weight[i], 20);
    }
}
END_TEST

/* A vertex in every face. test_surface_steps.c counts the steps that it takes. */
START_TEST(frames_at_a_vertex_of_high_valence_are_consistent)
{
    struct field_case of = case_of(fan(50000));
    ck_assert_uint_eq(of.surface.component_count, 1);
    check_entries(&of);
}
END_TEST

static enum hatch_status make(void *context, struct hatch_arena *to, struct hatch_arena *temporary,
                              struct hatch_err *why)
{
    struct field_case *of = context;
    return hatch_frames_make(&of->surface, to, temporary, &of->frames, why);
}

START_TEST(every_failed_allocation_is_a_limit)
{
    struct field_case of = case_of_shape(HATCH_SHAPE_TORUS, 100, 0);
    hatch_test_fail_alloc(make, &of, &of.frames, sizeof of.frames);
}
END_TEST

static Suite *suite(void)
{
    Suite *suite = suite_create("frames");
    TCase *tests = tcase_create("frames");
    tcase_add_checked_fixture(tests, begin, end);
    tcase_add_test(tests, frames_of_every_shape_are_consistent);
    tcase_add_test(tests, scaled_angles_satisfy_gauss_bonnet);
    tcase_add_test(tests, transport_on_a_plane_keeps_directions);
    tcase_add_test(tests, transport_over_folded_faces_keeps_directions);
    tcase_add_test(tests, transport_on_a_sphere_keeps_the_meridian);
    tcase_add_test(tests, sliver_weights_are_positive_and_bounded);
    tcase_add_test(tests, frames_at_a_vertex_of_high_valence_are_consistent);
    tcase_add_test(tests, every_failed_allocation_is_a_limit);
    suite_add_tcase(suite, tests);
    return suite;
}

HATCH_TEST_MAIN(suite)
