/* Parameters whose values change from frame to frame. */
#include "run.h"

#include "render-gl/mode/params.h"

START_TEST(a_motion_goes_back_and_forth)
{
    for (int i = 0; i < 10; i++) {
        double whole_s = 0.5 + i % 5, start_s = 2 * whole_s * i;
        ck_assert_double_eq_tol(params_swing(start_s, whole_s), 0, 1e-12);
        ck_assert_double_eq_tol(params_swing(start_s + 0.25 * whole_s, whole_s), 0.25, 1e-12);
        ck_assert_double_eq_tol(params_swing(start_s + whole_s, whole_s), 1, 1e-12);
        ck_assert_double_eq_tol(params_swing(start_s + 1.25 * whole_s, whole_s), 0.75, 1e-12);
    }
}
END_TEST

START_TEST(whole_numbers_are_rounded_to_the_nearest)
{
    int64_t value = 1;
    const struct cmd_option option = {.name = "count", .type = CMD_INT, .minimum = 0, .maximum = 9, .value = &value};
    const struct param param = {.option = &option};
    ck_assert(params_set(&param, (const double[2]){2.6, 0}));
    ck_assert_int_eq(value, 3);
    ck_assert(!params_set(&param, (const double[2]){3.4, 0}));
}
END_TEST

static Suite *suite(void)
{
    Suite *suite = suite_create("params");
    TCase *tests = tcase_create("params");
    tcase_add_test(tests, a_motion_goes_back_and_forth);
    tcase_add_test(tests, whole_numbers_are_rounded_to_the_nearest);
    suite_add_tcase(suite, tests);
    return suite;
}
HATCH_TEST_MAIN(suite)
