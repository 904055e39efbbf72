#include <math.h>
#include <stdbool.h>
#include <stdlib.h>

#include "arenas.h"
#include "fail_alloc.h"
#include "measure/border_figures.h"

enum { SIDE = 64, BORDER = SIDE / 2 };

static struct hatch_border_figures figures;

/* Horizontal strokes, two pixels wide, every eight rows.
 *   cut  every stroke of so many ends at the border in the middle; 0: none */
static struct hatch_image strokes(uint32_t cut)
{
    struct hatch_image image;
    HATCH_TEST_OK(hatch_image_make(&keep, SIDE, SIDE, "Y", &image, &err), &err);
    for (uint32_t i = 0; i < SIDE * SIDE; i++) {
        uint32_t x = i % SIDE, y = i / SIDE;
        bool ink = (y % 8 == 4 || y % 8 == 5) && !(cut && y / 8 % cut == 0 && x >= BORDER);
        image.pixels[i] = ink ? 0 : 1;
    }
    return image;
}

/* Two patches side by side, with a mixture of their greys in the pixels that are nearer to the border than soft_px.
 *   clear  the left half is transparent */
static struct hatch_image patches(uint32_t soft_px, bool clear)
{
    struct hatch_image image;
    HATCH_TEST_OK(hatch_image_make(&keep, SIDE, SIDE, "YA", &image, &err), &err);
    for (uint32_t i = 0; i < SIDE * SIDE; i++) {
        double at = soft_px ? ((double)(i % SIDE) + 0.5 - BORDER) / soft_px : i % SIDE < BORDER ? -1 : 1;
        image.pixels[2 * i] = (float)(0.5 + 0.2 * fmax(-1, fmin(1, at)));
        image.pixels[2 * i + 1] = clear && i % SIDE < BORDER ? 0 : 1;
    }
    return image;
}

static void measure(const struct hatch_image *picture, const struct hatch_image *shown)
{
    HATCH_TEST_OK(hatch_measure_borders(picture, shown, &scratch, &figures, &err), &err);
}

START_TEST(strokes_that_cross_go_on)
{
    struct hatch_image picture = strokes(0), shown = patches((uint32_t)_i, false);
    measure(&picture, &shown);
    ck_assert_double_eq_tol(figures.across, 1, 1e-12);
    ck_assert_double_eq_tol(figures.inside, 1, 1e-12);
    ck_assert_double_eq_tol(figures.continuity, 1, 1e-12);
}
END_TEST

START_TEST(strokes_that_end_at_the_border_do_not)
{
    struct hatch_image picture = strokes(1), shown = patches((uint32_t)_i, false);
    measure(&picture, &shown);
    ck_assert_double_eq_tol(figures.across, 0, 1e-12);
    ck_assert_double_eq_tol(figures.inside, 1, 1e-12);
    ck_assert_double_eq_tol(figures.continuity, 0, 1e-12);
}
END_TEST

/* Two columns of the one patch do not go on; the few columns of the other are connected to the one patch. */
START_TEST(ink_goes_on_for_more_than_two_pixels)
{
    struct hatch_image picture = strokes(0), shown = patches(0, false);
    const uint32_t beyond = (uint32_t)_i;
    for (uint32_t i = 0; i < SIDE * SIDE; i++)
        if (i % SIDE >= BORDER + beyond)
            picture.pixels[i] = 1;
    measure(&picture, &shown);
    ck_assert_double_eq_tol(figures.across, beyond > 2 ? 1 : beyond / (2.0 + beyond), 1e-12);
    ck_assert_double_eq_tol(figures.inside, 1, 1e-12);
}
END_TEST

/* Of six strokes, three have two columns near the border, and three have four. */
START_TEST(the_share_is_that_of_the_ink)
{
    struct hatch_image picture = strokes(2), shown = patches(0, false);
    measure(&picture, &shown);
    ck_assert_double_eq_tol(figures.across, 2.0 / 3, 1e-12);
    ck_assert_double_eq_tol(figures.continuity, 2.0 / 3, 1e-12);
}
END_TEST

/* Strokes that end everywhere end at borders, too: this is not the borders' fault. */
START_TEST(ends_inside_patches_are_taken_into_account)
{
    struct hatch_image picture = strokes(0), shown = patches(0, false);
    for (uint32_t i = 0; i < SIDE * SIDE; i++)
        if (i % SIDE % 16 == 0)
            picture.pixels[i] = 1;
    measure(&picture, &shown);
    ck_assert_double_eq_tol(figures.across, 0, 1e-12);
    ck_assert_double_eq_tol(figures.inside, 0, 1e-12);
    ck_assert(isnan(figures.continuity));
}
END_TEST

START_TEST(outlines_are_no_borders)
{
    struct hatch_image picture = strokes(1), shown = patches(0, true);
    measure(&picture, &shown);
    ck_assert(isnan(figures.across) && isnan(figures.inside) && isnan(figures.continuity));
}
END_TEST

static enum hatch_status measure_again(void *context, struct hatch_arena *into, struct hatch_arena *temporary,
                                       struct hatch_err *why)
{
    const struct hatch_image *pictures = context;
    (void)into;
    return hatch_measure_borders(&pictures[0], &pictures[1], temporary, &figures, why);
}

START_TEST(every_failed_allocation_is_a_limit)
{
    struct hatch_image pictures[2] = {strokes(1), patches(0, false)};
    hatch_test_fail_alloc(measure_again, pictures, &figures, sizeof figures);
}
END_TEST

static Suite *suite(void)
{
    Suite *made = suite_create("measure borders");
    TCase *tests = tcase_create("borders");
    tcase_add_checked_fixture(tests, begin, end);
    tcase_add_loop_test(tests, strokes_that_cross_go_on, 0, 5);
    tcase_add_loop_test(tests, strokes_that_end_at_the_border_do_not, 0, 5);
    tcase_add_loop_test(tests, ink_goes_on_for_more_than_two_pixels, 1, 5);
    tcase_add_test(tests, the_share_is_that_of_the_ink);
    tcase_add_test(tests, ends_inside_patches_are_taken_into_account);
    tcase_add_test(tests, outlines_are_no_borders);
    tcase_add_test(tests, every_failed_allocation_is_a_limit);
    suite_add_tcase(made, tests);
    return made;
}

HATCH_TEST_MAIN(suite)
