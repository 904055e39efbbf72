#include "run.h"

#include <math.h>

#include "shared/picture.h"

enum { PIXELS = 2, CHANNELS = 4 };

/* Colours that are not finite become the fallback, and alpha 0; NaN as the fallback is that of alpha, too. */
START_TEST(numbers_that_are_not_finite_are_replaced)
{
    static const float numbers[PIXELS * CHANNELS] = {NAN, 1, INFINITY, NAN, -INFINITY, 2, 3, 0.5f};
    static const float wanted[PIXELS * CHANNELS] = {0.25f, 1, 0.25f, 0, 0.25f, 2, 3, 0.5f};
    struct hatch_arena arena;
    struct hatch_image image;
    struct hatch_err err;
    hatch_arena_init(&arena, 1 << 20);
    HATCH_TEST_OK(hatch_image_make(&arena, PIXELS, 1, "RGBA", &image, &err), &err);
    for (int known = 0; known < 2; known++) {
        for (int i = 0; i < PIXELS * CHANNELS; i++)
            image.pixels[i] = numbers[i];
        ck_assert_uint_eq(cmd_replace_non_finite(&image, known ? 0.25f : NAN), 4);
        for (int i = 0; i < PIXELS * CHANNELS; i++)
            if (known || isfinite(numbers[i]))
                ck_assert_float_eq(image.pixels[i], wanted[i]);
            else
                ck_assert_float_nan(image.pixels[i]);
        ck_assert_uint_eq(cmd_replace_non_finite(&image, 7), known ? 0 : 4);
    }
    hatch_arena_free(&arena);
}
END_TEST

/* The last of three channels is a colour. */
START_TEST(pictures_without_alpha_have_colours_alone)
{
    struct hatch_arena arena;
    struct hatch_image image;
    struct hatch_err err;
    hatch_arena_init(&arena, 1 << 20);
    HATCH_TEST_OK(hatch_image_make(&arena, PIXELS, 1, "RGB", &image, &err), &err);
    for (int i = 0; i < PIXELS * 3; i++)
        image.pixels[i] = NAN;
    ck_assert_uint_eq(cmd_replace_non_finite(&image, 1), PIXELS * 3);
    for (int i = 0; i < PIXELS * 3; i++)
        ck_assert_float_eq(image.pixels[i], 1);
    hatch_arena_free(&arena);
}
END_TEST

static Suite *suite(void)
{
    Suite *suite = suite_create("cmd picture");
    TCase *tests = tcase_create("picture");
    tcase_add_test(tests, numbers_that_are_not_finite_are_replaced);
    tcase_add_test(tests, pictures_without_alpha_have_colours_alone);
    suite_add_tcase(suite, tests);
    return suite;
}
HATCH_TEST_MAIN(suite)
