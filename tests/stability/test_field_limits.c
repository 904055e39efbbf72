/* Where simpler ways of smoothing a direction field fail and the present one does not. */
#include "field_make.h"

#define DEG (PI / 180)

static struct field_case noisy(enum hatch_shape shape, double noise_rad, double confidence, double **truth)
{
    struct field_case of = case_of_shape(shape, 6000, 1);
    *truth = HATCH_NEW(&keep, double, (size_t)of.surface.point_count * 3, &err);
    follow_truth(&of, shape, 0, confidence);
    memcpy(*truth, of.direction, (size_t)of.surface.point_count * 3 * sizeof(double));
    follow_truth(&of, shape, noise_rad, confidence);
    return of;
}

/* Returns the share of points whose direction is within a limit of the known one. */
static double share_within(const struct field_case *of, const double *direction, const double *truth, double limit_rad)
{
    uint32_t count = 0;
    for (uint32_t p = 0; p < of->surface.point_count; p++)
        count += line_angle(of, p, &direction[3 * (size_t)p], &truth[3 * (size_t)p]) <= limit_rad;
    return (double)count / of->surface.point_count;
}

static double smoothed_share(enum hatch_shape shape, double noise_rad, double confidence, double limit_rad)
{
    double *truth;
    struct field_case of = noisy(shape, noise_rad, confidence, &truth);
    struct hatch_field field = solve_case(&of, HATCH_FIELD_LINEAR, HATCH_FIELD_MULTIGRID, 0.5);
    return share_within(&of, field.direction, truth, limit_rad);
}

/* A uniform weight suits one level of noise: one that corrects errors of 10 degrees destroys exact directions.
 * Confidences of 1 / (1 + variance / 0.02²) suit both. */
START_TEST(a_uniform_weight_smooths_clean_data_away)
{
    const enum hatch_shape shapes[] = {HATCH_SHAPE_TORUS, HATCH_SHAPE_ELLIPSOID};
    const double noise[] = {10 * DEG, 0.01 * DEG}, limit[] = {3 * DEG, 0.1 * DEG};
    for (size_t k = 0; k < 2; k++) {
        double rough = 1 / (1 + noise[0] * noise[0] / 4e-4), clean = 1 / (1 + noise[1] * noise[1] / 4e-4);
        ck_assert_double_gt(smoothed_share(shapes[k], noise[0], rough, limit[0]), 0.8);
        ck_assert_double_lt(smoothed_share(shapes[k], noise[1], rough, limit[1]), 0.5);
        ck_assert_double_gt(smoothed_share(shapes[k], noise[1], clean, limit[1]), 0.99);
    }
}
END_TEST

/* Descent from the data over unit fields (Hertzmann & Zorin) keeps pairs of singularities made by noise: they are
 * local minima. The linear system has a single minimum. */
START_TEST(descent_keeps_singularities_of_noise)
{
    double *truth;
    struct field_case of = noisy(HATCH_SHAPE_ELLIPSOID, 40 * DEG, 0.02, &truth);
    struct hatch_field hz = solve_case(&of, HATCH_FIELD_HZ, HATCH_FIELD_MULTIGRID, 0.5);
    struct hatch_field linear = solve_case(&of, HATCH_FIELD_LINEAR, HATCH_FIELD_MULTIGRID, 0.5);
    ck_assert_uint_gt(singularities_of(&of, hz.direction).count, 4);
    ck_assert_uint_eq(singularities_of(&of, linear.direction).count, 4);
}
END_TEST

/* A plane of needles: a square grid compressed to a hundredth, with random diagonals. */
static struct field_case needles(void)
{
    struct hatch_mesh mesh;
    const uint32_t side = 24;
    HATCH_TEST_OK(hatch_mesh_make(&keep, (side + 1) * (side + 1), 2 * side * side, &mesh, &err), &err);
    for (uint32_t i = 0; i <= side; i++)
        for (uint32_t j = 0; j <= side; j++) {
            float *at = &mesh.attributes[0].data[3 * (size_t)(i * (side + 1) + j)];
            at[0] = (float)i + (float)hatch_random_unit(1, i, j) / 2;
            at[1] = ((float)j + (float)hatch_random_unit(2, i, j) / 2) / 100;
        }
    for (uint32_t q = 0; q < side * side; q++) {
        uint32_t a = q / side * (side + 1) + q % side, b = a + side + 1;
        bool other = hatch_random_unit(3, 0, q) < 0.5f;
        const uint32_t faces[2][6] = {{a, b, b + 1, a, b + 1, a + 1}, {a, b, a + 1, b, b + 1, a + 1}};
        memcpy(&mesh.indices[6 * (size_t)q], faces[other], sizeof faces[0]);
    }
    return case_of(mesh);
}

static double plain_cotangent(const struct field_case *of, uint32_t face, uint32_t c)
{
    const uint32_t *corner = &of->surface.corners[3 * (size_t)face];
    const double *at = &of->surface.points[3 * (size_t)corner[c]];
    double a[3], b[3], cross[3];
    hatch_vec_sub(&of->surface.points[3 * (size_t)corner[(c + 1) % 3]], at, a);
    hatch_vec_sub(&of->surface.points[3 * (size_t)corner[(c + 2) % 3]], at, b);
    hatch_vec_cross(a, b, cross);
    return hatch_vec_dot(a, b) / hatch_vec_length(cross);
}

/* Unclamped cotangent weights are negative on needles; clamped ones are positive, and one constraint still determines
 * the whole field. */
START_TEST(needles_have_positive_weights)
{
    struct field_case of = needles();
    uint32_t negative = 0;
    for (uint32_t side = 0; side < 3 * of.surface.face_count; side++) {
        uint32_t other = of.surface.opposite[side];
        if (other == HATCH_NO_SIDE)
            continue;
        negative +=
            plain_cotangent(&of, side / 3, (side % 3 + 2) % 3) + plain_cotangent(&of, other / 3, (other % 3 + 2) % 3) <
            0;
    }
    ck_assert_uint_gt(negative, of.surface.face_count / 10);
    for (uint32_t i = 0; i < of.surface.ring_first[of.surface.point_count]; i++)
        ck_assert_double_gt(of.frames.weight[i], 0);
    const double line[3] = {1, 1, 0};
    hatch_vec_copy(line, of.direction);
    double *constraint_weight = HATCH_NEW(&keep, double, of.surface.point_count, &err);
    constraint_weight[0] = 1;
    const struct hatch_field_problem problem = {&of.surface,   &of.frames,        of.direction,
                                                of.confidence, constraint_weight, false};
    const struct hatch_field_options options = {HATCH_FIELD_LINEAR, HATCH_FIELD_MULTIGRID, 0.5, 1e-10, 2000};
    struct hatch_field field;
    HATCH_TEST_OK(hatch_field_solve(&problem, &options, &keep, &scratch, &field, &err), &err);
    for (uint32_t p = 0; p < of.surface.point_count; p++)
        ck_assert_double_lt(line_angle(&of, p, &field.direction[3 * (size_t)p], line), 0.1 * DEG);
}
END_TEST

/* Mean angles after smoothing on a saddle, whose data has errors of 5 degrees: to the nearer principal axis beside the
 * lines on which the first direction jumps; and to the first axis in a small region whose data has the second. */
struct means {
    double beside_rad, region_rad;
};

static struct means smooth_jumps(bool principal, double confidence)
{
    double *truth, sum[2] = {0, 0}, count[2] = {0, 0};
    struct field_case of = noisy(HATCH_SHAPE_SADDLE, 5 * DEG, confidence, &truth);
    bool *region = HATCH_NEW(&keep, bool, of.surface.point_count, &err);
    for (uint32_t p = 0; p < of.surface.point_count; p++) {
        double *line = &of.direction[3 * (size_t)p], at[3];
        hatch_surface_position(&of.surface, p, at);
        region[p] = hypot(at[0] - 0.6, at[1]) < 0.08;
        if (region[p])
            hatch_frames_direction(&of.frames, p, hatch_frames_angle(&of.frames, p, line) + PI / 2, line);
    }
    const struct hatch_field_problem problem = {&of.surface, &of.frames, of.direction, of.confidence, NULL, principal};
    const struct hatch_field_options options = {HATCH_FIELD_LINEAR, HATCH_FIELD_MULTIGRID, 0.5, 1e-6, 2000};
    struct hatch_field field;
    HATCH_TEST_OK(hatch_field_solve(&problem, &options, &keep, &scratch, &field, &err), &err);
    for (uint32_t p = 0; p < of.surface.point_count; p++) {
        double at[3], angle = line_angle(&of, p, &field.direction[3 * (size_t)p], &truth[3 * (size_t)p]);
        hatch_surface_position(&of.surface, p, at);
        double off = fabs(fabs(at[0]) - fabs(at[1]));
        if (!region[p] && (off < 0.02 || off > 0.2))
            continue;
        sum[region[p]] += region[p] ? angle : fmin(angle, PI / 2 - angle);
        count[region[p]]++;
    }
    return (struct means){sum[0] / count[0], sum[1] / count[1]};
}

START_TEST(smoothing_over_a_jump_bends_the_axes)
{
    ck_assert_double_gt(smooth_jumps(false, 0.01).beside_rad, 10 * DEG);
    ck_assert_double_lt(smooth_jumps(true, 0.01).beside_rad, 6 * DEG);
}
END_TEST

START_TEST(a_region_of_swapped_axes_is_corrected)
{
    ck_assert_double_lt(smooth_jumps(true, 0.1).region_rad, 10 * DEG);
}
END_TEST

static Suite *suite(void)
{
    Suite *suite = suite_create("field limits");
    TCase *tests = tcase_create("field");
    tcase_add_checked_fixture(tests, begin, end);
    tcase_add_test(tests, a_uniform_weight_smooths_clean_data_away);
    tcase_add_test(tests, descent_keeps_singularities_of_noise);
    tcase_add_test(tests, needles_have_positive_weights);
    tcase_add_test(tests, smoothing_over_a_jump_bends_the_axes);
    tcase_add_test(tests, a_region_of_swapped_axes_is_corrected);
    suite_add_tcase(suite, tests);
    return suite;
}

HATCH_TEST_MAIN(suite)
