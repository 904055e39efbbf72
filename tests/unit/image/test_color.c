#include <math.h>
#include <string.h>

#include "image/color.h"
#include "run.h"

static bool parse(const char *text, float rgb[3])
{
    return hatch_color_from_hex((struct hatch_text){text, strlen(text)}, rgb);
}

START_TEST(digits_are_srgb)
{
    float rgb[3];
    ck_assert(parse("ff8000", rgb));
    ck_assert(rgb[0] == 1 && rgb[1] == hatch_srgb_to_linear(128 / 255.0f) && rgb[2] == 0);
    ck_assert(parse("F80", rgb));
    ck_assert(rgb[0] == 1 && rgb[1] == hatch_srgb_to_linear(136 / 255.0f) && rgb[2] == 0);
}
END_TEST

START_TEST(other_texts_are_rejected_and_change_nothing)
{
    static const char *const bad[] = {"", "f", "ff", "ffff", "fffff", "fffffff", "ggg", "#fff", "12345 ", "-12"};
    for (size_t i = 0; i < sizeof bad / sizeof *bad; i++) {
        float rgb[3] = {7, 8, 9};
        ck_assert_msg(!parse(bad[i], rgb), "%s", bad[i]);
        ck_assert(rgb[0] == 7 && rgb[1] == 8 && rgb[2] == 9);
    }
}
END_TEST

/* Red, yellow, green and so on are 60 degrees apart and have chroma 1; greys have chroma 0. */
START_TEST(hues_are_angles)
{
    static const float wheel[6][3] = {{1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0, 1, 1}, {0, 0, 1}, {1, 0, 1}};
    double red[2] = {1, 0}, chroma[2];
    for (int i = 0; i < 6; i++) {
        float pixels[8] = {wheel[i][0], wheel[i][1], wheel[i][2], 5, wheel[i][0], wheel[i][1], wheel[i][2], -5};
        struct hatch_image image = {.width = 2, .height = 1, .channel_count = 4, .pixels = pixels};
        hatch_color_chroma(&image, chroma);
        ck_assert_double_eq_tol(hypot(chroma[0], chroma[1]), 1, 1e-12);
        ck_assert_double_eq_tol(hatch_color_hue_between(red, chroma), i <= 3 ? 60 * i : 360 - 60 * i, 1e-9);
    }
    ck_assert_double_eq_tol(hatch_color_hue_between((const double[2]){1, 2}, (const double[2]){3, 1}), 45, 1e-9);
    ck_assert_double_eq_tol(hatch_color_hue_between((const double[2]){-2, 4}, (const double[2]){2, -4}), 180, 1e-9);
    float grey[6] = {0.25f, 0.25f, 0.25f, 0.5f, 0.5f, 0.5f};
    struct hatch_image image = {.width = 1, .height = 2, .channel_count = 3, .pixels = grey};
    hatch_color_chroma(&image, chroma);
    ck_assert_double_eq_tol(hypot(chroma[0], chroma[1]), 0, 1e-12);
}
END_TEST

static Suite *suite(void)
{
    Suite *suite = suite_create("image color");
    TCase *tests = tcase_create("color");
    tcase_add_test(tests, digits_are_srgb);
    tcase_add_test(tests, other_texts_are_rejected_and_change_nothing);
    tcase_add_test(tests, hues_are_angles);
    suite_add_tcase(suite, tests);
    return suite;
}
HATCH_TEST_MAIN(suite)
