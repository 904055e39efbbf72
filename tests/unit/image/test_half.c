#include "run.h"

#include <math.h>
#include <stdbool.h>
#include <string.h>

#include "image/image.h"

#define HALVES 65536

static bool is_number(uint32_t half)
{
    return (half & 0x7c00) != 0x7c00 || (half & 0x3ff) == 0;
}

START_TEST(every_half_is_converted_to_float_and_back)
{
    for (uint32_t half = 0; half < HALVES; half++) {
        float wide = hatch_float_from_half((uint16_t)half);
        if (is_number(half))
            ck_assert_uint_eq(hatch_half_from_float(wide), half);
        else
            ck_assert(isnan(wide) && (hatch_half_from_float(wide) & 0x7fff) == 0x7e00);
    }
}
END_TEST

/* The definition: mantissa times a power of two. */
START_TEST(values_are_those_of_the_format)
{
    for (uint32_t half = 0; half < 0x7c00; half++) {
        int exponent = (int)(half >> 10);
        double mantissa = half & 0x3ff;
        double want = exponent ? ldexp(1 + mantissa / 1024, exponent - 15) : ldexp(mantissa, -24);
        ck_assert_double_eq((double)hatch_float_from_half((uint16_t)half), want);
        ck_assert_double_eq((double)hatch_float_from_half((uint16_t)(half | 0x8000)), -want);
    }
    ck_assert(isinf(hatch_float_from_half(0x7c00)) && hatch_float_from_half(0xfc00) < 0);
}
END_TEST

START_TEST(a_float_is_rounded_to_the_nearest_half_and_ties_to_even)
{
    for (uint32_t half = 0; half < 0x7bff; half++) {
        double low = (double)hatch_float_from_half((uint16_t)half);
        double high = (double)hatch_float_from_half((uint16_t)(half + 1));
        float middle = (float)((low + high) / 2);
        ck_assert_uint_eq(hatch_half_from_float(middle), half + (half & 1));
        ck_assert_uint_eq(hatch_half_from_float(nextafterf(middle, 0)), half);
        ck_assert_uint_eq(hatch_half_from_float(nextafterf(middle, 1e6f)), half + 1);
    }
    ck_assert_uint_eq(hatch_half_from_float(65519.0f), 0x7bff);
    ck_assert_uint_eq(hatch_half_from_float(65520.0f), 0x7c00);
    ck_assert_uint_eq(hatch_half_from_float(INFINITY), 0x7c00);
    ck_assert_uint_eq(hatch_half_from_float(-1e30f), 0xfc00);
}
END_TEST

START_TEST(rows_are_converted_like_single_numbers_for_every_length_and_stride)
{
    static float values[3 * 200], back[3 * 200];
    static uint16_t halves[200];
    for (size_t i = 0; i < 600; i++)
        values[i] = (float)i * 0.37f - 90;
    for (size_t count = 0; count < 200; count += 13)
        for (size_t stride = 1; stride <= 3; stride++) {
            memset(back, 0, sizeof back);
            hatch_halves_from_floats(values, stride, halves, count);
            hatch_floats_from_halves(halves, count, back, stride);
            for (size_t i = 0; i < count; i++) {
                ck_assert_uint_eq(halves[i], hatch_half_from_float(values[i * stride]));
                ck_assert(back[i * stride] == hatch_float_from_half(halves[i]));
            }
        }
}
END_TEST

static Suite *suite(void)
{
    Suite *suite = suite_create("image half");
    TCase *tests = tcase_create("half");
    tcase_add_test(tests, every_half_is_converted_to_float_and_back);
    tcase_add_test(tests, values_are_those_of_the_format);
    tcase_add_test(tests, a_float_is_rounded_to_the_nearest_half_and_ties_to_even);
    tcase_add_test(tests, rows_are_converted_like_single_numbers_for_every_length_and_stride);
    suite_add_tcase(suite, tests);
    return suite;
}
HATCH_TEST_MAIN(suite)
