#include "arenas.h"

#include <math.h>
#include <string.h>

#include "fail_alloc.h"
#include "filter/difference.h"

static struct hatch_image flat(uint32_t width, uint32_t height, const char *names, float value)
{
    struct hatch_image image;
    HATCH_TEST_OK(hatch_image_make(&keep, width, height, names, &image, &err), &err);
    for (size_t i = 0; i < (size_t)width * height * image.channel_count; i++)
        image.pixels[i] = value;
    return image;
}

START_TEST(equal_images_do_not_differ)
{
    struct hatch_image a = flat(7, 5, "RGB", 0.3f);
    struct hatch_difference d;
    double low = 1;
    hatch_image_difference(&a, &a, &d);
    ck_assert(d.max == 0 && d.mean == 0 && d.bias == 0 && d.rmse == 0 && d.differing == 0);
    ck_assert(isinf(d.psnr_db) && d.psnr_db > 0);
    HATCH_TEST_OK(hatch_image_low_difference(&a, &a, 8, &scratch, &low, &err), &err);
    ck_assert(low == 0);
}
END_TEST

/* One value of 2 by 2 by 3 is lower by 0.5, another higher by 0.25, in two of four pixels. */
START_TEST(statistics_match_their_formulas)
{
    struct hatch_image a = flat(2, 2, "RGB", 0.5f), b = flat(2, 2, "RGB", 0.5f);
    struct hatch_difference d;
    a.pixels[0] = 0;
    a.pixels[4] = 0.75f;
    hatch_image_difference(&a, &b, &d);
    ck_assert_double_eq_tol(d.max, 0.5, 1e-12);
    ck_assert_double_eq_tol(d.mean, 0.75 / 12, 1e-12);
    ck_assert_double_eq_tol(d.bias, -0.25 / 12, 1e-12);
    ck_assert_double_eq_tol(d.rmse, sqrt((0.25 + 0.0625) / 12), 1e-12);
    ck_assert_double_eq_tol(d.psnr_db, -10 * log10((0.25 + 0.0625) / 12), 1e-9);
    ck_assert_double_eq_tol(d.differing, 0.5, 1e-12);
}
END_TEST

/* NaN in one image alone, in both, and a difference of 0.5 beside them. */
START_TEST(values_that_are_no_numbers_differ_from_numbers)
{
    struct hatch_image a = flat(2, 2, "Y", 0.5f), b = flat(2, 2, "Y", 0.5f);
    struct hatch_difference d;
    double low;
    a.pixels[0] = b.pixels[0] = NAN;
    hatch_image_difference(&a, &b, &d);
    ck_assert(d.max == 0 && d.mean == 0 && d.differing == 0);
    b.pixels[1] = NAN;
    a.pixels[2] = 1;
    for (int side = 0; side < 2; side++) {
        hatch_image_difference(side ? &b : &a, side ? &a : &b, &d);
        ck_assert(isinf(d.max));
        ck_assert_double_eq_tol(d.mean, 0.125, 1e-12);
        ck_assert_double_eq_tol(d.differing, 0.5, 1e-12);
        HATCH_TEST_OK(hatch_image_low_difference(&a, &b, 2, &scratch, &low, &err), &err);
        ck_assert_double_eq_tol(low, 0.125, 1e-12);
    }
}
END_TEST

/* A checkerboard differs from grey in every pixel, but hardly in its low frequencies. */
START_TEST(a_checkerboard_is_grey_at_low_frequencies)
{
    struct hatch_image board = flat(32, 32, "Y", 0), grey = flat(32, 32, "Y", 0.5f);
    struct hatch_difference d;
    double low2, low3, low99;
    for (uint32_t i = 0; i < 32 * 32; i++)
        board.pixels[i] = (float)((i % 32 + i / 32) % 2);
    hatch_image_difference(&board, &grey, &d);
    ck_assert_double_eq(d.max, 0.5);
    HATCH_TEST_OK(hatch_image_low_difference(&board, &grey, 2, &scratch, &low2, &err), &err);
    HATCH_TEST_OK(hatch_image_low_difference(&board, &grey, 3, &scratch, &low3, &err), &err);
    HATCH_TEST_OK(hatch_image_low_difference(&board, NULL, 99, &scratch, &low99, &err), &err);
    ck_assert_double_eq_tol(low2, 0, 1e-12);
    ck_assert_double_eq_tol(low3, 0.5 / 9, 1e-12);
    ck_assert_double_eq_tol(low99, 0.5, 1e-12); /* the window is no larger than the image */
}
END_TEST

START_TEST(the_worst_window_is_found_anywhere)
{
    for (uint32_t at = 0; at < 20 * 12; at += 7) {
        struct hatch_image a = flat(20, 12, "YA", 0), b = flat(20, 12, "YA", 0);
        double low;
        a.pixels[2 * at + at % 2] = -0.8f;
        HATCH_TEST_OK(hatch_image_low_difference(&a, &b, 4, &scratch, &low, &err), &err);
        ck_assert_double_eq_tol(low, 0.8f / 16, 1e-9);
    }
}
END_TEST

START_TEST(even_change_has_no_second_difference)
{
    struct hatch_image before = flat(4, 4, "Y", 0.25f), now = flat(4, 4, "Y", 0.5f);
    struct hatch_image after = flat(4, 4, "Y", 0.75f), change = flat(4, 4, "Y", 9);
    ck_assert_double_eq(hatch_image_second_difference(&before, &now, &after, &change), 0);
    now.pixels[5] = 0;
    ck_assert_double_eq(hatch_image_second_difference(&before, &now, &after, &change), 1.0 / 16);
    ck_assert_double_eq((double)change.pixels[5], 1);
    ck_assert_double_eq((double)change.pixels[4], 0);
    ck_assert_double_eq(hatch_image_mean(&now), 7.5 / 16);
}
END_TEST

static enum hatch_status low(void *context, struct hatch_arena *arena, struct hatch_arena *temporary,
                             struct hatch_err *error)
{
    double *difference = context;
    struct hatch_image image;
    HATCH_TRY(hatch_image_make(arena, 9, 9, "Y", &image, error));
    return hatch_image_low_difference(&image, NULL, 3, temporary, difference, error);
}

START_TEST(failed_allocations_are_reported)
{
    double difference = -1;
    hatch_test_fail_alloc(low, &difference, &difference, sizeof difference);
}
END_TEST

static Suite *suite(void)
{
    Suite *suite = suite_create("filter difference");
    TCase *tests = tcase_create("difference");
    tcase_add_checked_fixture(tests, begin, end);
    tcase_add_test(tests, equal_images_do_not_differ);
    tcase_add_test(tests, values_that_are_no_numbers_differ_from_numbers);
    tcase_add_test(tests, statistics_match_their_formulas);
    tcase_add_test(tests, a_checkerboard_is_grey_at_low_frequencies);
    tcase_add_test(tests, the_worst_window_is_found_anywhere);
    tcase_add_test(tests, even_change_has_no_second_difference);
    tcase_add_test(tests, failed_allocations_are_reported);
    suite_add_tcase(suite, tests);
    return suite;
}
HATCH_TEST_MAIN(suite)
