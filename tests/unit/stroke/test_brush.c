#include "arenas.h"

#include <math.h>
#include <stdbool.h>
#include <string.h>

#include "fail_alloc.h"
#include "stroke/brush.h"

static void check_sums(const struct hatch_brush *brush)
{
    for (uint32_t x = 0; x < brush->width; x++) {
        double sum = 0;
        for (uint32_t y = 0; y < brush->height; y++) {
            float alpha = brush->alpha[y * brush->width + x];
            ck_assert(alpha >= 0 && alpha <= 1); /* NaN fails */
            ck_assert_double_eq_tol((double)brush->cumulative[x * (brush->height + 1) + y], sum / brush->height, 1e-5);
            sum += (double)alpha;
        }
        ck_assert_double_eq_tol((double)brush->cumulative[x * (brush->height + 1) + brush->height], sum / brush->height,
                                1e-5);
    }
}

START_TEST(built_in_brushes_have_ink_in_the_middle)
{
    struct hatch_brush brush;
    HATCH_TEST_OK(hatch_brush_make((enum hatch_brush_kind)_i, &keep, &brush, &err), &err);
    ck_assert_int_eq((int)brush.kind, _i);
    check_sums(&brush);
    float middle = brush.alpha[brush.height / 2 * brush.width + brush.width / 2];
    ck_assert_float_ge(middle, 0.95f);
    if (_i == HATCH_BRUSH_ROUND) /* its ends are computed when it is drawn */
        ck_assert_float_eq(brush.alpha[0], 1.0f);
    else
        ck_assert_float_le(brush.alpha[0], 0.5f * middle); /* no square corners */
    bool grainy = _i == HATCH_BRUSH_PENCIL || _i == HATCH_BRUSH_CRAYON || _i == HATCH_BRUSH_CHARCOAL;
    ck_assert_int_eq(brush.grain != NULL, grainy);
    for (uint32_t y = 0; y < brush.height; y++) /* both sides of a stroke are equal */
        for (uint32_t x = 0; x < brush.width; x++)
            ck_assert_float_eq_tol(brush.alpha[y * brush.width + x],
                                   brush.alpha[(brush.height - 1 - y) * brush.width + x], 1e-5f);
}
END_TEST

/* Grain wraps: steps across the border are about as large as steps inside. */
START_TEST(grain_is_seamless_and_within_bounds)
{
    struct hatch_brush brush;
    const uint32_t n = HATCH_GRAIN_SIZE;
    HATCH_TEST_OK(hatch_brush_make(HATCH_BRUSH_CHARCOAL, &keep, &brush, &err), &err);
    double inside = 0, across = 0, mean = 0;
    for (uint32_t y = 0; y < n; y++)
        for (uint32_t x = 0; x < n; x++) {
            float here = brush.grain[y * n + x];
            ck_assert(here >= 0 && here <= 1);
            mean += (double)here / (n * n);
            double step = fabs((double)(here - brush.grain[y * n + (x + 1) % n]));
            *(x + 1 < n ? &inside : &across) += x + 1 < n ? step / (n * (n - 1)) : step / n;
        }
    ck_assert(mean > 0.2 && mean < 0.95);
    ck_assert_double_le(across, 1.6 * inside);
}
END_TEST

START_TEST(the_disc_has_the_area_of_a_disc)
{
    struct hatch_brush brush;
    HATCH_TEST_OK(hatch_brush_make(HATCH_BRUSH_STIPPLE, &keep, &brush, &err), &err);
    double sum = 0;
    for (uint32_t i = 0; i < brush.width * brush.height; i++)
        sum += (double)brush.alpha[i];
    ck_assert_double_eq_tol(sum / (brush.width * brush.height), 0.785398, 0.02);
}
END_TEST

START_TEST(names_are_those_of_the_style_file)
{
    ck_assert_str_eq(hatch_brush_name(HATCH_BRUSH_INK), "ink");
    ck_assert_str_eq(hatch_brush_name(HATCH_BRUSH_STIPPLE), "stipple");
    ck_assert_ptr_null(hatch_brush_name(HATCH_BRUSH_IMAGE));
    ck_assert_ptr_null(hatch_brush_name((enum hatch_brush_kind)(-1)));
}
END_TEST

static struct hatch_brush from_pixels(const char *names, const float *pixels, uint32_t count)
{
    struct hatch_image image;
    struct hatch_brush brush;
    HATCH_TEST_OK(hatch_image_make(&keep, count, 1, names, &image, &err), &err);
    memcpy(image.pixels, pixels, count * strlen(names) * sizeof *pixels);
    HATCH_TEST_OK(hatch_brush_from_image(&image, &keep, &brush, &err), &err);
    ck_assert_int_eq(brush.kind, HATCH_BRUSH_IMAGE);
    ck_assert_ptr_null(brush.grain);
    check_sums(&brush);
    return brush;
}

START_TEST(dark_is_ink_and_non_finite_pixels_are_paper)
{
    const float grey[] = {0, 0.25f, 1, 2, -3, NAN, INFINITY, -INFINITY};
    const float want[] = {1, 0.75f, 0, 0, 1, 0, 0, 1};
    struct hatch_brush brush = from_pixels("Y", grey, 8);
    for (int i = 0; i < 8; i++)
        ck_assert_float_eq(brush.alpha[i], want[i]);
}
END_TEST

START_TEST(colours_are_converted_to_luminance)
{
    const float colours[] = {1, 0, 0, 0, 1, 0, 0, 0, 1, 0.5f, 0.5f, 0.5f};
    struct hatch_brush brush = from_pixels("RGB", colours, 4);
    ck_assert_float_eq_tol(brush.alpha[0], 1 - 0.2126f, 1e-6f);
    ck_assert_float_eq_tol(brush.alpha[1], 1 - 0.7152f, 1e-6f);
    ck_assert_float_eq_tol(brush.alpha[2], 1 - 0.0722f, 1e-6f);
    ck_assert_float_eq_tol(brush.alpha[3], 0.5f, 1e-6f);
}
END_TEST

/* A transparent image with black ink, and an opaque one, whose alpha is ignored. */
START_TEST(alpha_is_used_if_it_varies)
{
    const float transparent[] = {0, 0, 0, 0.5f, 0, 1}, opaque[] = {0.2f, 1, 1, 1, 0.6f, 1};
    struct hatch_brush brush = from_pixels("YA", transparent, 3);
    ck_assert_float_eq(brush.alpha[0], 0);
    ck_assert_float_eq(brush.alpha[1], 0.5f);
    ck_assert_float_eq(brush.alpha[2], 1);
    brush = from_pixels("YA", opaque, 3);
    ck_assert_float_eq_tol(brush.alpha[0], 0.8f, 1e-6f);
    ck_assert_float_eq(brush.alpha[1], 0);
    ck_assert_float_eq_tol(brush.alpha[2], 0.4f, 1e-6f);
}
END_TEST

START_TEST(an_image_without_ink_is_rejected)
{
    struct hatch_image image;
    struct hatch_brush brush = {.width = 77};
    HATCH_TEST_OK(hatch_image_make(&keep, 3, 3, "Y", &image, &err), &err);
    for (int i = 0; i < 9; i++)
        image.pixels[i] = i % 2 ? NAN : 1;
    ck_assert_int_eq(hatch_brush_from_image(&image, &keep, &brush, &err), HATCH_BAD_INPUT);
    ck_assert_ptr_nonnull(strstr(err.text, "no ink"));
    ck_assert_uint_eq(brush.width, 77);
}
END_TEST

static enum hatch_status make(void *context, struct hatch_arena *to, struct hatch_arena *temporary,
                              struct hatch_err *error)
{
    (void)temporary;
    return hatch_brush_make(HATCH_BRUSH_PENCIL, to, context, error);
}

static enum hatch_status make_from_image(void *context, struct hatch_arena *to, struct hatch_arena *temporary,
                                         struct hatch_err *error)
{
    (void)temporary;
    float black = 0;
    struct hatch_image image = {.width = 1, .height = 1, .channel_count = 1, .pixels = &black};
    return hatch_brush_from_image(&image, to, context, error);
}

START_TEST(every_failed_allocation_is_a_status)
{
    struct hatch_brush brush = {0};
    ck_assert_uint_ge(hatch_test_fail_alloc(make, &brush, &brush, sizeof brush), 3);
    memset(&brush, 0, sizeof brush);
    ck_assert_uint_ge(hatch_test_fail_alloc(make_from_image, &brush, &brush, sizeof brush), 2);
}
END_TEST

static Suite *suite(void)
{
    Suite *suite = suite_create("stroke brush");
    TCase *tests = tcase_create("brush");
    tcase_add_checked_fixture(tests, begin, end);
    tcase_add_loop_test(tests, built_in_brushes_have_ink_in_the_middle, 0, HATCH_BRUSH_IMAGE);
    tcase_add_test(tests, grain_is_seamless_and_within_bounds);
    tcase_add_test(tests, the_disc_has_the_area_of_a_disc);
    tcase_add_test(tests, names_are_those_of_the_style_file);
    tcase_add_test(tests, dark_is_ink_and_non_finite_pixels_are_paper);
    tcase_add_test(tests, colours_are_converted_to_luminance);
    tcase_add_test(tests, alpha_is_used_if_it_varies);
    tcase_add_test(tests, an_image_without_ink_is_rejected);
    tcase_add_test(tests, every_failed_allocation_is_a_status);
    suite_add_tcase(suite, tests);
    return suite;
}
HATCH_TEST_MAIN(suite)
