#include "run.h"
#include "stroke/frame.h"

static void check_clip(float a, float b, float reach, float low, float high, float want_low, float want_high)
{
    hatch_frame_clip(a, b, reach, &low, &high);
    if (want_low > want_high) {
        ck_assert_msg(low > high, "%g .. %g", (double)low, (double)high);
        return;
    }
    ck_assert_float_eq_tol(low, want_low, 1e-5f);
    ck_assert_float_eq_tol(high, want_high, 1e-5f);
}

/* |2 x - 4| <= 6 where -1 <= x <= 5, and |-2 x - 4| <= 6 where -5 <= x <= 1. */
START_TEST(a_range_is_clipped_to_a_strip)
{
    check_clip(2, -4, 6, -10, 10, -1, 5);
    check_clip(-2, -4, 6, -10, 10, -5, 1);
    check_clip(2, -4, 6, 0, 10, 0, 5);
    check_clip(2, -4, 6, -10, 3, -1, 3);
    check_clip(2, -4, 6, 1, 2, 1, 2);
    check_clip(2, -4, 6, 6, 10, 1, 0);
    check_clip(2, -4, 6, -10, -2, 1, 0);
    check_clip(0, 6, 6, -10, 10, -10, 10);
    check_clip(0, -6, 6, -10, 10, -10, 10);
    check_clip(0, 6.1f, 6, -10, 10, 1, 0);
    check_clip(0, -6.1f, 6, -10, 10, 1, 0);
    check_clip(1e-5f, 0, 1, -10, 10, -10, 10);
}
END_TEST

START_TEST(pixels_are_wrapped_on_a_torus)
{
    static const int32_t at[] = {-129, -128, -1, 0, 127, 128, 300}, want[] = {127, 0, 127, 0, 127, 0, 44};
    for (int i = 0; i < 7; i++)
        ck_assert_uint_eq(hatch_frame_wrap(at[i], 128), (uint32_t)want[i]);
}
END_TEST

static Suite *suite(void)
{
    Suite *made = suite_create("stroke frame");
    TCase *tests = tcase_create("frame");
    tcase_add_test(tests, a_range_is_clipped_to_a_strip);
    tcase_add_test(tests, pixels_are_wrapped_on_a_torus);
    suite_add_tcase(made, tests);
    return made;
}

HATCH_TEST_MAIN(suite)
