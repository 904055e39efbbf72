#include <math.h>

#include "base/random.h"
#include "fail_alloc.h"
#include "measure/tam_figures.h"
#include "placement/canvas.h"
#include "tam/whole.h"
#include "tam_map.h"

static struct test_map map;
static struct hatch_tam_image_figures figures;

static void begin(void)
{
    map_begin();
    map_style("ink", NULL, &map);
}

static void measure(uint32_t tone, uint32_t level)
{
    HATCH_TEST_OK(hatch_measure_tam_image(&map.tam, tone, level, &map_scratch, &figures, &map_err), &map_err);
}

static float *pixels(uint32_t tone, uint32_t level)
{
    return map.columns[tone].levels[level].pixels;
}

static uint64_t missing(void)
{
    uint64_t count = 12345;
    struct hatch_tam_strokes strokes = {&map.strokes, &map.style, &map.brush, map.options.growth};
    HATCH_TEST_OK(hatch_measure_tam_nesting(&map.tam, &strokes, &map_scratch, &count, &map_err), &map_err);
    return count;
}

START_TEST(the_mean_is_one_minus_reflectance)
{
    map_fill(&map);
    for (uint32_t i = 0; i < 64 * 64; i++)
        pixels(1, 0)[i] = i % 4 ? 1 : 0.5f;
    measure(1, 0);
    ck_assert_uint_eq(figures.size_px, 64);
    ck_assert_double_eq_tol(figures.mean, 0.125, 1e-12);
    ck_assert_double_eq_tol(figures.error, 0.125 - 0.3, 1e-6);
}
END_TEST

START_TEST(colours_are_measured_by_their_mean)
{
    map_fill(&map);
    struct hatch_image *image = &map.columns[0].levels[0];
    HATCH_TEST_OK(hatch_image_make(&map_arena, 64, 64, "RGB", image, &map_err), &map_err);
    for (uint32_t i = 0; i < 64 * 64; i++)
        image->pixels[3 * i] = 0.75f;
    map.tam.color = true;
    measure(0, 0);
    ck_assert_double_eq_tol(figures.mean, 0.75, 1e-12);
}
END_TEST

START_TEST(one_lighter_pixel_is_counted)
{
    map_fill(&map);
    for (uint32_t tone = 0; tone < 6; tone++)
        for (uint32_t level = 0; level < 7; level++) {
            measure(tone, level);
            ck_assert_uint_eq(figures.lighter_pixels, 0);
        }
    pixels(4, 1)[77] = nextafterf(pixels(3, 1)[77], 2);
    measure(4, 1);
    ck_assert_uint_eq(figures.lighter_pixels, 1);
    measure(4, 0);
    ck_assert_uint_eq(figures.lighter_pixels, 0);
}
END_TEST

/* White noise has no seam; a ramp jumps from its end to its start. */
START_TEST(a_seam_is_detected)
{
    map_fill(&map);
    for (uint32_t i = 0; i < 64 * 64; i++)
        pixels(0, 0)[i] = hatch_random_unit(3, 3, i);
    measure(0, 0);
    ck_assert_double_lt(fabs(figures.seam_z[0]), 3);
    ck_assert_double_lt(fabs(figures.seam_z[1]), 3);
    for (uint32_t i = 0; i < 64 * 64; i++)
        pixels(0, 0)[i] = 0.2f * hatch_random_unit(3, 3, i) + 0.8f * (float)(i % 64) / 64;
    measure(0, 0);
    ck_assert_double_gt(figures.seam_z[0], 5);
    ck_assert_double_lt(fabs(figures.seam_z[1]), 3);
    for (uint32_t i = 0; i < 64 * 64; i++)
        pixels(0, 0)[i] = 0.2f * hatch_random_unit(3, 3, i) + 0.8f * (float)(i / 64) / 64;
    measure(0, 0);
    ck_assert_double_lt(fabs(figures.seam_z[0]), 3);
    ck_assert_double_gt(figures.seam_z[1], 5);
}
END_TEST

START_TEST(a_flat_image_has_no_seam_and_no_spread)
{
    map_fill(&map);
    for (uint32_t i = 0; i < 64 * 64; i++)
        pixels(0, 0)[i] = 0.3f;
    measure(0, 0);
    ck_assert_double_eq(figures.seam_z[0], 0);
    for (uint32_t box = 0; box < HATCH_EVENNESS_BOXES; box++)
        ck_assert_double_eq_tol(figures.spread[box], 0, 1e-9);
}
END_TEST

/* The mean of n independent pixels has 1/√n of their standard deviation. */
START_TEST(the_spread_of_white_noise_falls_with_the_box_size)
{
    struct hatch_image image;
    double spread[HATCH_EVENNESS_BOXES];
    HATCH_TEST_OK(hatch_image_make(&map_arena, 256, 256, "Y", &image, &map_err), &map_err);
    for (uint32_t i = 0; i < 256 * 256; i++)
        image.pixels[i] = hatch_random_unit(12, 1, i);
    HATCH_TEST_OK(hatch_measure_spreads(&image, &map_scratch, spread, &map_err), &map_err);
    for (uint32_t box = 0; box < HATCH_EVENNESS_BOXES; box++) {
        double side = 256.0 / hatch_evenness_divisors[box];
        ck_assert_double_eq_tol(spread[box] * sqrt(12) * side, 1, 0.02 + side / 256);
    }
    image.width = image.height = 16; /* a box of 1/32 is half a pixel */
    HATCH_TEST_OK(hatch_measure_spreads(&image, &map_scratch, spread, &map_err), &map_err);
    ck_assert_double_eq(spread[0], 0);
    ck_assert_double_gt(spread[1], 0.2);
}
END_TEST

/* Draws one image again from the list, without one stroke. */
static void redraw(const struct hatch_stroke *without, uint32_t tone, uint32_t level)
{
    struct hatch_canvas canvas;
    const struct hatch_canvas_options options = {&map.style, &map.brush, 64, 2, false, false};
    HATCH_TEST_OK(hatch_canvas_make(&options, &map_arena, &canvas, &map_err), &map_err);
    for (uint32_t i = 0; i < map.strokes.count; i++) {
        const struct hatch_stroke *s = &map.strokes.items[i];
        if (s != without && s->column <= tone && s->level >= level)
            hatch_canvas_draw(&canvas, s, level, 0, 1);
    }
    uint32_t size = 64 >> level;
    for (uint32_t i = 0; i < size * size; i++)
        pixels(tone, level)[i] = canvas.paper[level][i];
}

START_TEST(a_stroke_missing_from_one_image_is_found)
{
    map_fill(&map);
    ck_assert_uint_eq(missing(), 0);
    redraw(NULL, 0, 0); /* the same image, drawn from the list */
    ck_assert_uint_eq(missing(), 0);
    for (uint32_t i = 0; i < 5; i++)
        for (uint32_t level = 0; level <= map.strokes.items[i].level; level++) {
            ck_assert_uint_eq(map.strokes.items[i].column, 0);
            redraw(&map.strokes.items[i], 0, level);
            ck_assert_uint_eq(missing(), 1);
            redraw(NULL, 0, level);
        }
}
END_TEST

/* Rounding to 1/8 makes pixels lighter by up to 1/16, to 1/32 by up to 1/64. White pixels are missing nonetheless. */
START_TEST(no_stroke_is_missing_from_a_rounded_map)
{
    static const float tolerances[] = {0.1f, 0.01f, 0.002f};
    map_style(_i ? "speckle" : "ink", NULL, &map);
    map_fill(&map);
    for (uint32_t k = 0; k < sizeof tolerances / sizeof *tolerances; k++) {
        struct hatch_image levels[HATCH_MIP_LEVELS_MAX], *image = map.columns[0].levels;
        struct hatch_mipmap rounded = map.columns[0];
        rounded.levels = levels;
        for (uint32_t level = 0; level < rounded.level_count; level++) {
            HATCH_TEST_OK(hatch_image_make(&map_arena, image[level].width, image[level].height, _i ? "RGB" : "Y",
                                           &levels[level], &map_err),
                          &map_err);
            for (uint32_t i = 0; i < image[level].width * image[level].height * (_i ? 3 : 1); i++)
                levels[level].pixels[i] = 1;
        }
        map.columns[0].levels = levels;
        ck_assert_uint_gt(missing(), 10);
        map.columns[0].levels = image;
        hatch_tam_round(&map.columns[0], map.tam.levels, (double)tolerances[k], &rounded);
        map.columns[0].levels = levels;
        map.tam.whole.tolerance = tolerances[k];
        ck_assert_uint_eq(missing(), 0);
        map.tam.whole.tolerance = 0;
        ck_assert_uint_gt(missing(), 10);
        map.columns[0].levels = image;
    }
}
END_TEST

/* A pixel of a coloured stroke that is white in one channel. */
START_TEST(a_stroke_missing_from_one_channel_is_found)
{
    map_style("speckle", NULL, &map);
    map_fill(&map);
    ck_assert(map.tam.color);
    ck_assert_uint_eq(missing(), 0);
    const struct hatch_stroke *stroke = &map.strokes.items[0];
    const struct hatch_canvas_options options = {&map.style, &map.brush, 64, 2, true, false};
    struct hatch_canvas canvas;
    HATCH_TEST_OK(hatch_canvas_make(&options, &map_arena, &canvas, &map_err), &map_err);
    (void)hatch_canvas_try(&canvas, stroke, 0, 1);
    uint32_t darkest = 0;
    for (uint32_t i = 0; i < canvas.footprint.count; i++)
        darkest = canvas.footprint.alpha[i] > canvas.footprint.alpha[darkest] ? i : darkest;
    for (size_t c = 0; c < 3; c++) {
        float *at = &pixels(stroke->column, 0)[3 * (size_t)canvas.footprint.at[darkest] + c], before = *at;
        ck_assert_float_lt(before, 0.95f);
        *at = 1;
        ck_assert_uint_ge(missing(), 1);
        *at = before;
    }
    ck_assert_uint_eq(missing(), 0);
}
END_TEST

START_TEST(growing_strokes_nest)
{
    map.options.growth = 0.5f;
    map.options.tones = 9;
    map_fill(&map);
    ck_assert_uint_eq(missing(), 0);
    for (uint32_t tone = 0; tone < 9; tone++)
        for (uint32_t level = 0; level < 2; level++) {
            measure(tone, level);
            ck_assert_uint_eq(figures.lighter_pixels, 0);
        }
}
END_TEST

START_TEST(a_script_of_another_map_is_refused)
{
    map_fill(&map);
    uint64_t count = 7;
    struct hatch_tam_strokes strokes = {&map.strokes, &map.style, &map.brush, 0};
    map.strokes.items[3].level = 2;
    ck_assert_int_eq(hatch_measure_tam_nesting(&map.tam, &strokes, &map_scratch, &count, &map_err), HATCH_BAD_INPUT);
    ck_assert_ptr_nonnull(strstr(map_err.text, "stroke 4: column 0, level 2"));
    ck_assert_uint_eq(count, 7);
}
END_TEST

START_TEST(the_darkness_of_a_stroke_is_its_area)
{
    double darkness = 0;
    map_style(NULL, "brush stipple\nwidth 4\nlength 0.5 0.5", &map);
    map_fill(&map);
    struct hatch_tam_strokes strokes = {&map.strokes, &map.style, &map.brush, 0};
    for (uint32_t level = 0; level < 2; level++) {
        HATCH_TEST_OK(hatch_measure_stroke_darkness(&map.tam, &strokes, level, &map_scratch, &darkness, &map_err),
                      &map_err);
        uint32_t size = 64 >> level;
        /* an ellipse of 4 pixels by half a tile; tolerance: the last strokes of an image are shorter */
        ck_assert_double_eq_tol(darkness / (0.785 * 4 * 0.5 * size / (size * size)), 1, 0.1);
    }
}
END_TEST

START_TEST(random_strokes_have_evenness_one)
{
    double ratio[6 * HATCH_EVENNESS_BOXES], mean = 0;
    map.options.size_px = 128;
    map.options.levels = 3;
    map_fill(&map);
    struct hatch_tam_strokes strokes = {&map.strokes, &map.style, &map.brush, 0};
    HATCH_TEST_OK(hatch_measure_evenness(&map.tam, &strokes, 8, &map_scratch, ratio, &map_err), &map_err);
    for (uint32_t i = 0; i < 6 * HATCH_EVENNESS_BOXES; i++)
        ck_assert(ratio[i] > 0.1 && ratio[i] < 0.9);
    for (uint64_t run = 0; run < 8; run++) {
        struct hatch_canvas canvas;
        const struct hatch_canvas_options options = {&map.style, &map.brush, 128, 1, false, false};
        HATCH_TEST_OK(hatch_canvas_make(&options, &map_arena, &canvas, &map_err), &map_err);
        for (uint32_t tone = 0, i = 0; tone < 6; tone++) {
            for (; i < map.strokes.count && map.strokes.items[i].column == tone; i++) {
                struct hatch_stroke stroke = map.strokes.items[i];
                stroke.x = hatch_random_unit(100 + run, 1, i);
                stroke.y = hatch_random_unit(100 + run, 2, i);
                hatch_canvas_draw(&canvas, &stroke, 0, 0, 1);
            }
            memcpy(pixels(tone, 0), canvas.paper[0], 128 * 128 * sizeof(float));
        }
        HATCH_TEST_OK(hatch_measure_evenness(&map.tam, &strokes, 8, &map_scratch, ratio, &map_err), &map_err);
        for (uint32_t i = 0; i < 6 * HATCH_EVENNESS_BOXES; i++)
            mean += ratio[i] / (6 * HATCH_EVENNESS_BOXES * 8);
    }
    ck_assert_double_eq_tol(mean, 1, 0.1);
}
END_TEST

static enum hatch_status all(void *context, struct hatch_arena *keep, struct hatch_arena *scratch,
                             struct hatch_err *err)
{
    (void)keep;
    uint64_t count;
    double number, ratio[6 * HATCH_EVENNESS_BOXES];
    struct hatch_tam_strokes strokes = {&map.strokes, &map.style, &map.brush, 0};
    HATCH_TRY(hatch_measure_tam_image(&map.tam, 1, 0, scratch, &figures, err));
    HATCH_TRY(hatch_measure_tam_nesting(&map.tam, &strokes, scratch, &count, err));
    HATCH_TRY(hatch_measure_stroke_darkness(&map.tam, &strokes, 1, scratch, &number, err));
    (void)context;
    return hatch_measure_evenness(&map.tam, &strokes, 2, scratch, ratio, err);
}

START_TEST(every_failed_allocation_is_a_limit)
{
    map_fill(&map);
    ck_assert_uint_ge(hatch_test_fail_alloc(all, NULL, NULL, 0), 50);
}
END_TEST

static Suite *suite(void)
{
    Suite *suite = suite_create("measure tam");
    TCase *tests = tcase_create("tam figures");
    tcase_add_checked_fixture(tests, begin, map_end);
    tcase_add_test(tests, the_mean_is_one_minus_reflectance);
    tcase_add_test(tests, colours_are_measured_by_their_mean);
    tcase_add_test(tests, one_lighter_pixel_is_counted);
    tcase_add_test(tests, a_seam_is_detected);
    tcase_add_test(tests, a_flat_image_has_no_seam_and_no_spread);
    tcase_add_test(tests, the_spread_of_white_noise_falls_with_the_box_size);
    tcase_add_test(tests, a_stroke_missing_from_one_image_is_found);
    tcase_add_loop_test(tests, no_stroke_is_missing_from_a_rounded_map, 0, 2);
    tcase_add_test(tests, a_stroke_missing_from_one_channel_is_found);
    tcase_add_test(tests, growing_strokes_nest);
    tcase_add_test(tests, a_script_of_another_map_is_refused);
    tcase_add_test(tests, the_darkness_of_a_stroke_is_its_area);
    tcase_add_test(tests, random_strokes_have_evenness_one);
    tcase_add_test(tests, every_failed_allocation_is_a_limit);
    suite_add_tcase(suite, tests);
    return suite;
}
HATCH_TEST_MAIN(suite)
