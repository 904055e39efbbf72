#include <math.h>
#include <stdlib.h>

#include "arenas.h"
#include "fail_alloc.h"
#include "measure/ink_figures.h"

enum { SIDE = 96 };

static struct hatch_ink_figures figures;

/* Stripes of 16 pixels: 8 pixels of ink, the outer ones of which are edges, and 8 of paper. */
static struct hatch_image stripes(const char *channels, float darkness, float edge)
{
    struct hatch_image image;
    HATCH_TEST_OK(hatch_image_make(&keep, SIDE, SIDE, channels, &image, &err), &err);
    for (uint32_t i = 0; i < SIDE * SIDE; i++) {
        uint32_t x = i % SIDE % 16;
        float dark = x == 0 || x == 7 ? edge : x < 8 ? darkness : 0;
        for (uint32_t c = 0; c < image.channel_count; c++)
            image.pixels[i * image.channel_count + c] = c == 3 ? 1 : 1 - dark;
    }
    return image;
}

static void measure(const struct hatch_image *picture, const struct hatch_image *reference)
{
    HATCH_TEST_OK(hatch_measure_ink(picture, reference, &scratch, &figures, &err), &err);
}

START_TEST(edges_of_ink_do_not_count_as_grey_strokes)
{
    struct hatch_image image = stripes(_i ? "RGBA" : "Y", 1, 0.5f);
    measure(&image, NULL);
    ck_assert_double_eq_tol(figures.inked, 0.5, 1e-12);
    ck_assert_double_eq_tol(figures.grey, 0.25, 1e-12);
    ck_assert_double_eq_tol(figures.grey_strokes, 0, 1e-12);
    ck_assert_double_eq_tol(figures.black, 0.75, 1e-12);
    ck_assert(isnan(figures.tone_error) && isnan(figures.tone_worst) && isnan(figures.edge_error));
    ck_assert(isnan(figures.tone_rms) && isnan(figures.uneven24));
}
END_TEST

START_TEST(grey_strokes_are_measured)
{
    struct hatch_image image = stripes("Y", 0.6f, 0.3f);
    measure(&image, NULL);
    ck_assert_double_eq_tol(figures.grey, 1, 1e-12);
    ck_assert_double_eq_tol(figures.grey_strokes, 1, 1e-12);
    ck_assert_double_eq(figures.black, 0);
    image = stripes("Y", 0.85f, 0.95f);
    measure(&image, NULL);
    ck_assert_double_eq_tol(figures.black, 0.25, 1e-12);
    image = stripes("Y", 0.2f, 0.2f);
    measure(&image, NULL);
    ck_assert_double_eq_tol(figures.inked, 0.5, 1e-12);
    ck_assert_double_eq_tol(figures.grey, 0, 1e-12);
}
END_TEST

START_TEST(paper_has_no_strokes)
{
    struct hatch_image image = stripes("RGB", 0, 0);
    measure(&image, &image);
    ck_assert_double_eq(figures.inked, 0);
    ck_assert(isnan(figures.grey) && isnan(figures.grey_strokes) && isnan(figures.black));
    ck_assert(isnan(figures.tone_error) && isnan(figures.tone_worst) && isnan(figures.tone_rms));
    ck_assert(isnan(figures.uneven24) && isnan(figures.edge_error));
}
END_TEST

/* Ink on a white reference: nothing says how dark it should be, and no figure says that it is right. */
START_TEST(ink_without_tone_has_no_errors_of_tone)
{
    struct hatch_image image = stripes("Y", 1, 1), paper = stripes("Y", 0, 0);
    measure(&image, &paper);
    ck_assert_double_gt(figures.inked, 0.4);
    ck_assert(isnan(figures.tone_error) && isnan(figures.tone_worst) && isnan(figures.tone_rms));
    ck_assert(isnan(figures.uneven24) && isnan(figures.edge_error));
}
END_TEST

/* Windows are two stripes wide, so that all have the same mean. */
START_TEST(tone_is_compared_by_windows)
{
    struct hatch_image image = stripes("Y", 1, 0.5f), even = stripes("RGB", 0, 0);
    for (uint32_t i = 0; i < SIDE * SIDE * 3; i++)
        even.pixels[i] = 0.6f;
    measure(&image, &even);
    ck_assert_double_eq_tol(figures.tone_error, 0.4375 - 0.4, 1e-6);
    ck_assert_double_eq_tol(figures.tone_worst, 0.4375 - 0.4, 1e-6);
    ck_assert_double_eq_tol(figures.tone_rms, 0.4375 - 0.4, 1e-6);
}
END_TEST

/* Stripes of 24 pixels, of ink and of paper in turn. The darkness of a window of 24 pixels is |24 - x mod 48| / 24,
 * where x is its left border. */
START_TEST(unevenness_is_the_deviation_between_windows)
{
    enum { SHIFTS = SIDE - 24 + 1 };
    struct hatch_image image = stripes("Y", 0, 0), flat = stripes("Y", 0, 0);
    double sum = 0, squares = 0, rms = 0;
    for (uint32_t i = 0; i < SIDE * SIDE; i++) {
        image.pixels[i] = i % SIDE % 48 < 24 ? 0 : 1;
        flat.pixels[i] = 0.75f;
    }
    measure(&image, &flat);
    for (int shift = 0; shift < SHIFTS; shift++) {
        double dark = abs(24 - shift % 48) / 24.0;
        sum += dark / SHIFTS;
        squares += dark * dark / SHIFTS;
    }
    ck_assert_double_eq_tol(figures.uneven24, sqrt(squares - sum * sum), 1e-6);
    for (int shift = 0; shift <= SIDE - 32; shift++) {
        int ink = 0;
        for (int x = shift; x < shift + 32; x++)
            ink += x % 48 < 24;
        rms += pow(ink / 32.0 - 0.25, 2) / (SIDE - 32 + 1);
    }
    ck_assert_double_eq_tol(figures.tone_rms, sqrt(rms), 1e-6);
}
END_TEST

/* The same error everywhere is an error of tone, but even. */
START_TEST(a_constant_error_is_even)
{
    struct hatch_image image = stripes("Y", 0, 0), flat = stripes("Y", 0, 0);
    for (uint32_t i = 0; i < SIDE * SIDE; i++) {
        image.pixels[i] = 0.25f;
        flat.pixels[i] = 0.75f;
    }
    measure(&image, &flat);
    ck_assert_double_eq_tol(figures.uneven24, 0, 1e-6);
    ck_assert_double_eq_tol(figures.tone_rms, 0.5, 1e-6);
}
END_TEST

START_TEST(edges_are_compared_where_the_reference_has_them)
{
    struct hatch_image image = stripes("Y", 1, 1), smooth = stripes("Y", 1, 0.5f);
    measure(&image, &smooth);
    ck_assert_double_eq_tol(figures.edge_error, 0.5, 1e-6);
    measure(&smooth, &smooth);
    ck_assert_double_eq(figures.edge_error, 0);
}
END_TEST

/* Makes smooth stripes at an angle, `width` wide at distances of `step`, or a disc of this diameter if step is 0. */
static struct hatch_image slanted(double angle, double width, double step, double darkness)
{
    struct hatch_image image;
    HATCH_TEST_OK(hatch_image_make(&keep, SIDE, SIDE, "Y", &image, &err), &err);
    for (uint32_t i = 0; i < SIDE * SIDE; i++) {
        double x = i % SIDE + 0.5 - SIDE / 2, y = (double)(i / SIDE) + 0.5 - SIDE / 2;
        double across = x * cos(angle) + y * sin(angle);
        double from = step > 0 ? fabs(across - step * round(across / step)) : hypot(x, y);
        image.pixels[i] = (float)(1 - darkness * fmin(fmax(0.5 + width / 2 - from, 0), 1));
    }
    return image;
}

START_TEST(the_width_of_strokes_is_measured_at_any_angle)
{
    static const double widths[] = {2, 3.5, 8};
    for (int degrees = 0; degrees < 180; degrees += 15)
        for (int w = 0; w < 3; w++) {
            struct hatch_image image = slanted(degrees * 0.0174533, widths[w], 24, _i ? 0.3 : 1);
            measure(&image, NULL);
            ck_assert_double_ge(figures.width_px, 0.94 * widths[w]);
            ck_assert_double_le(figures.width_px, 1.1 * widths[w]);
        }
    struct hatch_image disc = slanted(0, 40, 0, 1); /* twice its area over its outline is the radius */
    measure(&disc, NULL);
    ck_assert_double_eq_tol(figures.width_px, 20, 0.3);
}
END_TEST

START_TEST(without_an_outline_there_is_no_width)
{
    struct hatch_image image = stripes("Y", 0, 0);
    measure(&image, NULL);
    ck_assert(isnan(figures.width_px));
    for (uint32_t i = 0; i < SIDE * SIDE; i++)
        image.pixels[i] = 0;
    measure(&image, NULL);
    ck_assert(isnan(figures.width_px));
}
END_TEST

static enum hatch_status measure_again(void *context, struct hatch_arena *into, struct hatch_arena *temporary,
                                       struct hatch_err *why)
{
    (void)into;
    return hatch_measure_ink(context, context, temporary, &figures, why);
}

START_TEST(every_failed_allocation_is_a_limit)
{
    struct hatch_image image = stripes("Y", 1, 1);
    hatch_test_fail_alloc(measure_again, &image, &figures, sizeof figures);
}
END_TEST

static Suite *suite(void)
{
    Suite *made = suite_create("measure ink");
    TCase *tests = tcase_create("ink");
    tcase_add_checked_fixture(tests, begin, end);
    tcase_add_loop_test(tests, edges_of_ink_do_not_count_as_grey_strokes, 0, 2);
    tcase_add_test(tests, grey_strokes_are_measured);
    tcase_add_test(tests, paper_has_no_strokes);
    tcase_add_test(tests, ink_without_tone_has_no_errors_of_tone);
    tcase_add_test(tests, tone_is_compared_by_windows);
    tcase_add_test(tests, unevenness_is_the_deviation_between_windows);
    tcase_add_test(tests, a_constant_error_is_even);
    tcase_add_test(tests, edges_are_compared_where_the_reference_has_them);
    tcase_add_test(tests, every_failed_allocation_is_a_limit);
    tcase_add_loop_test(tests, the_width_of_strokes_is_measured_at_any_angle, 0, 2);
    tcase_add_test(tests, without_an_outline_there_is_no_width);
    suite_add_tcase(made, tests);
    return made;
}

HATCH_TEST_MAIN(suite)
