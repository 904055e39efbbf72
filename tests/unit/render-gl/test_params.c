/* The motion of parameters in the window. */
#include "run.h"

#include "render-gl/mode/params.h"

START_TEST(a_motion_goes_back_and_forth)
{
    for (int i = 0; i < 10; i++) {
        double start_s = 6.0 * i;
        ck_assert_double_eq_tol(params_swing(start_s, 3), 0, 1e-12);
        ck_assert_double_eq_tol(params_swing(start_s + 0.75, 3), 0.25, 1e-12);
        ck_assert_double_eq_tol(params_swing(start_s + 3, 3), 1, 1e-12);
        ck_assert_double_eq_tol(params_swing(start_s + 3.75, 3), 0.75, 1e-12);
    }
}
END_TEST

static Suite *suite(void)
{
    Suite *suite = suite_create("params");
    TCase *tests = tcase_create("params");
    tcase_add_test(tests, a_motion_goes_back_and_forth);
    suite_add_tcase(suite, tests);
    return suite;
}
HATCH_TEST_MAIN(suite)
