/* Figures of solid textures against closed forms. */
#include <math.h>
#include <stdbool.h>

#include "arenas.h"
#include "fail_alloc.h"
#include "measure/solid_figures.h"

enum { SIZE = 16, SAMPLES = 20 };

/* Fills a grey cube with values of 0 .. 255 at each texel. */
static struct hatch_solid grey_cube(uint8_t (*value)(uint32_t x, uint32_t y, uint32_t z))
{
    struct hatch_solid solid;
    HATCH_TEST_OK(hatch_solid_make(&keep, SIZE, 1, &solid, &err), &err);
    for (uint32_t i = 0; i < SIZE * SIZE * SIZE; i++)
        solid.texels[i] = value(i % SIZE, i / SIZE % SIZE, i / (SIZE * SIZE));
    return solid;
}

static struct hatch_image picture(uint32_t width, uint32_t height, const char *names,
                                  float (*value)(uint32_t x, uint32_t y, uint32_t c))
{
    struct hatch_image image;
    HATCH_TEST_OK(hatch_image_make(&keep, width, height, names, &image, &err), &err);
    uint32_t n = image.channel_count;
    for (uint32_t i = 0; i < width * height * n; i++)
        image.pixels[i] = value(i / n % width, i / n / width, i % n);
    return image;
}

static struct hatch_solid_figures measure(const struct hatch_solid *solid, const struct hatch_image *exemplar)
{
    struct hatch_solid_figures figures;
    HATCH_TEST_OK(hatch_measure_solid(solid, exemplar, SAMPLES, NULL, &scratch, &figures, &err), &err);
    return figures;
}

static uint8_t even(uint32_t x, uint32_t y, uint32_t z)
{
    (void)x, (void)y, (void)z;
    return 51;
}

static uint8_t halves(uint32_t x, uint32_t y, uint32_t z)
{
    (void)y, (void)z;
    return x < SIZE / 2 ? 0 : 255;
}

static uint8_t ramp(uint32_t x, uint32_t y, uint32_t z)
{
    (void)x, (void)z;
    return (uint8_t)(y * 17);
}

static uint8_t checkers(uint32_t x, uint32_t y, uint32_t z)
{
    return (x / 2 + y / 2 + z / 2) % 2 ? 255 : 0;
}

static float one_fifth(uint32_t x, uint32_t y, uint32_t c)
{
    (void)x, (void)y;
    return c == 3 ? 0.5f : 0.2f;
}

static float four_fifths(uint32_t x, uint32_t y, uint32_t c)
{
    (void)x, (void)y, (void)c;
    return 0.8f;
}

static float nothing(uint32_t x, uint32_t y, uint32_t c)
{
    (void)x, (void)y, (void)c;
    return 0;
}

static float board(uint32_t x, uint32_t y, uint32_t c)
{
    (void)c;
    return (x / 2 + y / 2) % 2 ? 1.0f : 0.0f;
}

START_TEST(a_constant_cube_has_no_steps_and_no_distance)
{
    struct hatch_solid solid = grey_cube(even);
    struct hatch_image same = picture(20, 12, "Y", one_fifth), other = picture(9, 30, "Y", four_fifths);
    struct hatch_solid_figures figures = measure(&solid, &same);
    ck_assert_double_eq_tol(figures.mean[0], 0.2, 1e-12);
    ck_assert_double_eq(figures.deviation[0], 0);
    ck_assert(isnan(figures.mean[1]) && isnan(figures.deviation[2]));
    ck_assert_double_eq(figures.step[0] + figures.step[1] + figures.step[2], 0);
    ck_assert_double_eq(figures.isotropy, 1);
    ck_assert_double_eq(figures.seam, 0);
    ck_assert_double_eq(figures.histogram, 0);
    ck_assert_double_eq(figures.neighborhood_all, 0);
    figures = measure(&solid, &other);
    ck_assert_double_eq_tol(figures.histogram, 0.6, 1e-12);
    ck_assert_double_eq_tol(figures.neighborhood[1], 0.6, 1e-12);
    struct hatch_image darker = picture(8, 8, "Y", nothing);
    ck_assert_double_eq_tol(measure(&solid, &darker).histogram, 0.2, 1e-12);
    ck_assert_double_eq_tol(figures.neighborhood_all, 0.6, 1e-12);
}
END_TEST

START_TEST(two_halves_step_once_inside_and_once_across_the_border)
{
    struct hatch_solid solid = grey_cube(halves);
    struct hatch_solid_figures figures = measure(&solid, NULL);
    ck_assert_double_eq_tol(figures.mean[0], 0.5, 1e-12);
    ck_assert_double_eq_tol(figures.deviation[0], 0.5, 1e-12);
    ck_assert_double_eq_tol(figures.step[0], 1.0 / (SIZE - 1), 1e-12);
    ck_assert_double_eq(figures.step[1], 0);
    ck_assert_double_eq(figures.isotropy, 0);
    ck_assert_double_eq(figures.seam, 1);
    ck_assert(isnan(figures.histogram) && isnan(figures.neighborhood[0]) && isnan(figures.neighborhood_all));
}
END_TEST

START_TEST(a_ramp_has_a_seam)
{
    struct hatch_solid solid = grey_cube(ramp);
    struct hatch_solid_figures figures = measure(&solid, NULL);
    ck_assert_double_eq_tol(figures.step[1], 17.0 / 255, 1e-12);
    ck_assert_double_eq_tol(figures.seam, 15, 1e-9);
}
END_TEST

START_TEST(slices_of_a_checkerboard_are_in_a_checkerboard)
{
    struct hatch_solid solid = grey_cube(checkers);
    struct hatch_image exemplar = picture(12, 12, "Y", board);
    struct hatch_solid_figures figures = measure(&solid, &exemplar);
    ck_assert_double_eq(figures.histogram, 0);
    ck_assert_double_eq(figures.neighborhood_all, 0);
    ck_assert_double_eq_tol(figures.isotropy, 1, 1e-12);
    ck_assert_double_eq(figures.seam, 1);
    struct hatch_solid shifted = grey_cube(checkers);
    for (uint32_t i = 0; i < SIZE * SIZE * SIZE; i++)
        shifted.texels[i] = solid.texels[i / SIZE * SIZE + (i + 3) % SIZE];
    ck_assert_double_eq(measure(&shifted, &exemplar).neighborhood_all, 0);
}
END_TEST

START_TEST(stripes_match_in_two_of_three_slices)
{
    struct hatch_solid solid = grey_cube(halves);
    struct hatch_image exemplar = picture(32, 8, "Y", one_fifth);
    for (uint32_t i = 0; i < 32 * 8; i++)
        exemplar.pixels[i] = i % 32 / 8 % 2 ? 1.0f : 0.0f;
    struct hatch_solid_figures figures = measure(&solid, &exemplar);
    ck_assert_double_eq(figures.neighborhood[1], 0);
    ck_assert_double_eq(figures.neighborhood[2], 0);
    ck_assert_double_eq(figures.neighborhood[0], 0); /* of one colour, as the middle of a stripe */
    for (uint32_t i = 0; i < 32 * 8; i++)
        exemplar.pixels[i] = i % 32 / 4 % 2 ? 1.0f : 0.0f;
    ck_assert_double_eq_tol(measure(&solid, &exemplar).neighborhood[0], sqrt(0.5), 1e-12);
}
END_TEST

START_TEST(grey_and_colours_are_compared)
{
    struct hatch_solid solid = grey_cube(even), colors;
    struct hatch_image grey = picture(10, 10, "YA", one_fifth), rgb = picture(10, 10, "RGBA", one_fifth);
    HATCH_TEST_OK(hatch_solid_make(&keep, SIZE, 3, &colors, &err), &err);
    memset(colors.texels, 51, (size_t)SIZE * SIZE * SIZE * 3);
    ck_assert_double_eq(measure(&solid, &rgb).neighborhood_all, 0);
    ck_assert_double_eq(measure(&colors, &grey).neighborhood_all, 0);
    ck_assert_double_eq(measure(&colors, &rgb).histogram, 0);
    ck_assert_double_eq_tol(measure(&colors, &rgb).mean[2], 0.2, 1e-12);
}
END_TEST

static enum hatch_status measure_once(void *context, struct hatch_arena *results, struct hatch_arena *temporary,
                                      struct hatch_err *error)
{
    static struct hatch_solid_figures figures;
    struct hatch_solid solid = grey_cube(even);
    struct hatch_image image = picture(300, 9, "RGB", one_fifth);
    (void)context, (void)results;
    return hatch_measure_solid(&solid, &image, 2, NULL, temporary, &figures, error);
}

START_TEST(each_allocation_may_fail)
{
    hatch_test_fail_alloc(measure_once, NULL, NULL, 0);
}
END_TEST

static Suite *suite(void)
{
    Suite *suite = suite_create("measure solid");
    TCase *tests = tcase_create("solid");
    tcase_add_checked_fixture(tests, begin, end);
    tcase_add_test(tests, a_constant_cube_has_no_steps_and_no_distance);
    tcase_add_test(tests, two_halves_step_once_inside_and_once_across_the_border);
    tcase_add_test(tests, a_ramp_has_a_seam);
    tcase_add_test(tests, slices_of_a_checkerboard_are_in_a_checkerboard);
    tcase_add_test(tests, stripes_match_in_two_of_three_slices);
    tcase_add_test(tests, grey_and_colours_are_compared);
    tcase_add_test(tests, each_allocation_may_fail);
    suite_add_tcase(suite, tests);
    return suite;
}
HATCH_TEST_MAIN(suite)
