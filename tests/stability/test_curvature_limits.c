/* Where fits over a fixed support fail and adaptive supports do not. Figures are angles to the known first principal
 * direction over five shapes, in degrees. */
#include "curvature_make.h"

#define FACES 6000

struct figures {
    double median, high; /* 95th percentile */
};

static struct figures measure(float noise, double radius, uint32_t degree, bool smoothed)
{
    struct angles angles = {0};
    for (int s = 0; s < 5; s++) {
        struct field_case of = case_with_truth(bent[s], FACES, noise);
        struct hatch_curvature found = estimate_case(&of, radius, degree);
        const double *direction = found.direction;
        if (smoothed) {
            const struct hatch_field_options options = {.smooth = 0.5, .tolerance = 1e-6, .iterations_max = 1000};
            const struct hatch_field_problem problem = {&of.surface,      &of.frames, found.direction,
                                                        found.confidence, NULL,       true};
            struct hatch_field field;
            HATCH_TEST_OK(hatch_frames_set_normals(&of.surface, found.normal, &scratch, &of.frames, &err), &err);
            HATCH_TEST_OK(hatch_field_solve(&problem, &options, &keep, &scratch, &field, &err), &err);
            direction = field.direction;
        }
        add_angles(&angles, &of, direction, false);
    }
    return (struct figures){percentile(&angles, 0.5), percentile(&angles, 0.95)};
}

START_TEST(small_supports_fail_on_noise)
{
    ck_assert_double_lt(measure(0, 2.6, 4, false).median, 0.01);
    ck_assert_double_gt(measure(0.05f, 2.6, 4, false).median, 5);
    ck_assert_double_gt(measure(0.2f, 2.6, 4, false).median, 20);
}
END_TEST

/* A quadric over a radius of eight edges cannot follow the surface. */
START_TEST(large_supports_fail_on_clean_points)
{
    ck_assert_double_lt(measure(0.05f, 8, 2, false).median, 4);
    ck_assert_double_gt(measure(0, 8, 2, false).median, 0.5);
}
END_TEST

START_TEST(adaptive_supports_suit_both)
{
    struct figures clean = measure(0, 0, 0, false);
    ck_assert_double_lt(clean.median, 0.01);
    ck_assert_double_lt(clean.high, 0.15);
    struct figures some = measure(0.05f, 0, 0, false), much = measure(0.2f, 0, 0, false);
    ck_assert_double_lt(some.median, 0.7);
    ck_assert_double_lt(some.high, 4);
    ck_assert_double_lt(much.median, 1.4);
    ck_assert_double_lt(much.high, 9);
}
END_TEST

/* With the confidence as weight, smoothing improves uncertain directions and keeps certain ones. */
START_TEST(smoothing_reduces_noise_and_keeps_clean_points)
{
    struct figures clean = measure(0, 0, 0, true), some = measure(0.05f, 0, 0, true), much = measure(0.2f, 0, 0, true);
    ck_assert_double_lt(clean.median, 0.01);
    ck_assert_double_lt(clean.high, 0.2);
    ck_assert_double_lt(some.median, 0.6);
    ck_assert_double_lt(some.high, 3);
    ck_assert_double_lt(much.median, 1.2);
    ck_assert_double_lt(much.high, 8);
}
END_TEST

static Suite *suite(void)
{
    Suite *all = suite_create("curvature limits");
    TCase *tests = tcase_create("supports");
    tcase_add_checked_fixture(tests, begin, end);
    tcase_add_test(tests, small_supports_fail_on_noise);
    tcase_add_test(tests, large_supports_fail_on_clean_points);
    tcase_add_test(tests, adaptive_supports_suit_both);
    tcase_add_test(tests, smoothing_reduces_noise_and_keeps_clean_points);
    suite_add_tcase(all, tests);
    return all;
}
HATCH_TEST_MAIN(suite)
