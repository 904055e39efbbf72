/* Inputs on which plain methods of making tonal art maps fail: the plain_ tests show the failure, the ours_ tests this
 * code. LONG=1 adds the largest size. */
#include <math.h>

#include "base/random.h"
#include "filter/pyramid.h"
#include "measure/tam_figures.h"
#include "placement/canvas.h"
#include "tam_map.h"

static struct test_map map;

static struct hatch_stroke random_stroke(uint64_t i, float length)
{
    return (struct hatch_stroke){.x = hatch_random_unit(21, 1, i),
                                 .y = hatch_random_unit(21, 2, i),
                                 .length = length,
                                 .angle_rad = 0.2f * (float)(i % 8),
                                 .width_px = map.style.width_px,
                                 .tone = map.style.ink};
}

static struct hatch_canvas make_canvas(uint32_t size_px)
{
    struct hatch_canvas canvas;
    const struct hatch_canvas_options options = {&map.style, &map.brush, size_px, 1, false, false};
    HATCH_TEST_OK(hatch_canvas_make(&options, &map_arena, &canvas, &map_err), &map_err);
    return canvas;
}

static double mean_of(uint32_t tone, uint32_t level)
{
    struct hatch_tam_image_figures figures;
    HATCH_TEST_OK(hatch_measure_tam_image(&map.tam, tone, level, &map_scratch, &figures, &map_err), &map_err);
    return figures.mean;
}

/* Checks that strokes nest and that no image is darker than its target by more than `over`. */
static void check_map(double over)
{
    uint64_t missing = 1;
    struct hatch_tam_strokes strokes = {&map.strokes, &map.style, &map.brush, 0};
    HATCH_TEST_OK(hatch_measure_tam_nesting(&map.tam, &strokes, &map_scratch, &missing, &map_err), &map_err);
    ck_assert_uint_eq(missing, 0);
    for (uint32_t tone = 0; tone < map.tam.tones; tone++)
        for (uint32_t level = 0; level < map.tam.levels; level++) {
            struct hatch_tam_image_figures f;
            HATCH_TEST_OK(hatch_measure_tam_image(&map.tam, tone, level, &map_scratch, &f, &map_err), &map_err);
            ck_assert_uint_eq(f.lighter_pixels, 0);
            ck_assert_msg(f.error <= over, "tone %u, level %u: %g too dark", tone, level, f.error);
        }
}

/* A stroke three tiles long overlaps itself. Plain: the darkness that it adds is its area, which counts the overlaps
 * repeatedly, and drawing it pixel by pixel inks them repeatedly. */
START_TEST(plain_a_stroke_longer_than_the_tile_is_counted_three_times)
{
    map_style(NULL, "brush stipple\nwidth 4\nlength 3 3\nink 0.5", &map);
    struct hatch_canvas canvas = make_canvas(64);
    struct hatch_stroke stroke = random_stroke(0, 3);
    double area = 3.0 * 64 * 4 * 0.785 / (64 * 64), plain = (double)stroke.tone * area;
    double gain = hatch_canvas_try(&canvas, &stroke, 0, 1);
    ck_assert_double_gt(plain, 2.2 * gain);
}
END_TEST

START_TEST(ours_a_stroke_longer_than_the_tile_inks_a_pixel_once)
{
    map_style(NULL, "brush stipple\nwidth 4\nlength 3 3\nink 0.5\ndirection 0 0 1", &map);
    struct hatch_canvas canvas = make_canvas(64);
    struct hatch_stroke stroke = random_stroke(0, 3);
    hatch_canvas_draw(&canvas, &stroke, 0, 0, 1);
    for (uint32_t i = 0; i < 64 * 64; i++)
        ck_assert_float_ge(canvas.paper[0][i], 0.4999f);
    map_style("ink", "length 1.5 3", &map);
    map_fill(&map);
    check_map(0.09); /* half of the darkness of the longest stroke on 32 pixels */
}
END_TEST

/* Wide charcoal on 64². Plain: strokes are added until the mean reaches the target, coarse to fine. */
START_TEST(plain_drawing_until_the_target_is_reached_overshoots)
{
    map_style("charcoal", NULL, &map);
    double worst = 0;
    for (uint64_t run = 0; run < 20; run++) {
        struct hatch_arena_mark mark = hatch_arena_mark(&map_arena);
        struct hatch_canvas canvas = make_canvas(32);
        for (uint64_t i = 0; canvas.darkness[0] < 0.15; i++) {
            struct hatch_stroke stroke = random_stroke(run * 1000 + i, 0.4f);
            hatch_canvas_draw(&canvas, &stroke, 0, 0, 1);
        }
        worst = fmax(worst, canvas.darkness[0] - 0.15);
        hatch_arena_rewind(&map_arena, mark);
    }
    ck_assert_double_gt(worst, 0.02);
}
END_TEST

START_TEST(ours_stops_before_a_stroke_that_increases_the_error)
{
    for (uint64_t seed = 1; seed <= 20; seed++) {
        struct hatch_arena_mark mark = hatch_arena_mark(&map_arena);
        map_style("charcoal", "candidates 60 20", &map);
        map.options.seed = seed;
        map_fill(&map);
        struct hatch_tam_strokes strokes = {&map.strokes, &map.style, &map.brush, 0};
        double stroke;
        HATCH_TEST_OK(hatch_measure_stroke_darkness(&map.tam, &strokes, 1, &map_scratch, &stroke, &map_err), &map_err);
        /* half of the longest stroke, which is 1.5 times as long as the mean */
        check_map(fmax(0.02, 0.75 * stroke));
        hatch_arena_rewind(&map_arena, mark);
    }
}
END_TEST

/* Plain: mip levels are the box-filtered finest level, in which strokes lose their width and their ink. */
START_TEST(plain_box_filtered_levels_lose_the_strokes)
{
    map_style("ink", NULL, &map);
    map.options.size_px = 256;
    map.options.levels = 4;
    map_fill(&map);
    struct hatch_image levels[HATCH_MIP_LEVELS_MAX] = {map.columns[0].levels[0]};
    struct hatch_mipmap plain = {.levels = levels};
    HATCH_TEST_OK(hatch_mipmap_complete(&plain, 1, &map_arena, &map_err), &map_err);
    double darkest[2] = {1, 1};
    for (uint32_t i = 0; i < 32 * 32; i++) {
        darkest[0] = fmin(darkest[0], (double)levels[3].pixels[i]);
        darkest[1] = fmin(darkest[1], (double)map.columns[0].levels[3].pixels[i]);
    }
    ck_assert_double_gt(darkest[0], 0.5); /* a grey haze at tone 0.15 */
    ck_assert_double_lt(darkest[1], 0.1); /* ours: a stroke of full ink */
    for (uint32_t level = 0; level < 4; level++)
        ck_assert_double_eq_tol(mean_of(0, level), 0.15, 0.02);
}
END_TEST

/* Ink that cannot reach the target: crossing strokes of 0.3 that do not darken each other. Plain: a loop until the
 * target is reached never ends. */
START_TEST(plain_thin_ink_never_reaches_its_target)
{
    map_style(NULL, "ink 0.3\noverlap flat", &map);
    struct hatch_canvas canvas = make_canvas(64);
    for (uint64_t i = 0; i < 5000; i++) {
        struct hatch_stroke stroke = random_stroke(i, 1);
        hatch_canvas_draw(&canvas, &stroke, 0, 0, 1);
    }
    ck_assert_double_le(canvas.darkness[0], 0.3001);
}
END_TEST

START_TEST(ours_ends_when_no_stroke_darkens_the_image)
{
    static const char *const lines[] = {"ink 0.3\noverlap flat\ndarkest 1", "ink 0.01\ndarkest 1\ncandidates 5 5",
                                        "ink 1\ndarkest 1"};
    map_style(NULL, lines[_i], &map);
    map_fill(&map);
    check_map(0.01);
    double dark = mean_of(5, 0);
    if (_i == 0)
        ck_assert(dark > 0.28 && dark <= 0.3001);
    else
        ck_assert_double_gt(dark, 0.95);
}
END_TEST

/* Target tones of nearly 0: no stroke is drawn, because one would be too dark. */
START_TEST(no_tone_draws_no_stroke)
{
    map_style("ink", "gamma 10\ndarkest 0.01", &map);
    map.options.tones = 20;
    map_fill(&map);
    for (uint32_t level = 0; level < 2; level++)
        ck_assert_double_eq(mean_of(0, level), 0);
    check_map(0.01);
}
END_TEST

/* One level, one tone, one candidate, the smallest size. */
START_TEST(one_level_one_tone_and_one_candidate_make_a_map)
{
    map_style(map_styles[_i], "candidates 1 1", &map);
    map.options.tones = map.options.levels = 1;
    map_fill(&map);
    check_map(0.01);
    ck_assert_double_eq_tol(mean_of(0, 0), (double)map.style.tone_max, 0.02);
}
END_TEST

/* Plain: strokes from single candidates are as uneven as random ones. Ours: a candidate moves to the best position near
 * it. */
START_TEST(strokes_of_single_candidates_are_more_even_than_random_ones)
{
    double ratio[6 * HATCH_EVENNESS_BOXES], mean = 0;
    map_style("ink", "candidates 1 1", &map);
    map.options.size_px = 256;
    map.options.levels = 4;
    map.options.method = _i ? HATCH_FILL_EXHAUSTIVE : HATCH_FILL_FIELD;
    map_fill(&map);
    struct hatch_tam_strokes strokes = {&map.strokes, &map.style, &map.brush, 0};
    HATCH_TEST_OK(hatch_measure_evenness(&map.tam, &strokes, 4, &map_scratch, ratio, &map_err), &map_err);
    for (uint32_t i = 0; i < 6; i++)
        mean += ratio[i * HATCH_EVENNESS_BOXES] / 6;
    if (_i)
        ck_assert(mean > 0.9 && mean < 1.1);
    else
        ck_assert_double_lt(mean, 0.8);
}
END_TEST

/* A brush image of one pixel: strokes are plain bars. */
START_TEST(a_stroke_image_of_one_pixel_draws_bars)
{
    struct hatch_image pixel;
    map_style("ink", NULL, &map);
    HATCH_TEST_OK(hatch_image_make(&map_arena, 1, 1, "Y", &pixel, &map_err), &map_err);
    HATCH_TEST_OK(hatch_brush_from_image(&pixel, &map_arena, &map.brush, &map_err), &map_err);
    map_fill(&map);
    check_map(0.02);
    ck_assert_double_eq_tol(mean_of(5, 0), 0.9, 0.01);
}
END_TEST

/* A brush image with ink in its middle only. Plain: candidates are scored along their whole length, and strokes form
 * bands, no more even than random ones. Ours: they are scored under their ink. */
START_TEST(strokes_with_empty_ends_are_placed_evenly)
{
    struct hatch_image image;
    double ratio[4 * HATCH_EVENNESS_BOXES], mean = 0;
    map_style("ink", "width 8\nlength 0.3 0.6\nink 0.7", &map);
    HATCH_TEST_OK(hatch_image_make(&map_arena, 30, 1, "Y", &image, &map_err), &map_err);
    for (uint32_t x = 0; x < 30; x++)
        image.pixels[x] = x < 10 || x >= 20;
    HATCH_TEST_OK(hatch_brush_from_image(&image, &map_arena, &map.brush, &map_err), &map_err);
    map.options.size_px = 256;
    map.options.tones = 4;
    map_fill(&map);
    struct hatch_tam_strokes strokes = {&map.strokes, &map.style, &map.brush, 0};
    HATCH_TEST_OK(hatch_measure_evenness(&map.tam, &strokes, 4, &map_scratch, ratio, &map_err), &map_err);
    for (uint32_t i = 0; i < 4; i++)
        mean += ratio[i * HATCH_EVENNESS_BOXES + 1] / 4;
    ck_assert_double_lt(mean, 0.5);
}
END_TEST

/* A stroke wider than the coarsest image. Plain: one stroke makes that image, and every darker one, black. Ours: it
 * stays white until its target is nearer to black than to white. */
START_TEST(a_stroke_wider_than_an_image_is_drawn_at_its_tone)
{
    map_style(NULL, "brush stipple\nwidth 64\nlength 0 0\ncandidates 50 50", &map);
    struct hatch_canvas canvas = make_canvas(32);
    struct hatch_stroke stroke = random_stroke(0, 0);
    double one = hatch_canvas_try(&canvas, &stroke, 0, 1);
    ck_assert_double_gt(one, 0.9);
    map_fill(&map);
    check_map(one / 2);
    ck_assert_double_eq(mean_of(0, 1), 0);
}
END_TEST

/* The largest size, and the smallest with the most tones. */
START_TEST(maps_are_made_at_the_limits_of_size)
{
    map_style("ink", "candidates 20 10", &map);
    map.options.size_px = getenv("LONG") ? 4096 : 1024;
    map.options.levels = getenv("LONG") ? 8 : 6;
    map.options.tones = 2;
    map_fill(&map);
    check_map(0.02);
    map_style("ink", "candidates 20 10", &map);
    map.options.tones = HATCH_TAM_TONES_MAX;
    map_fill(&map);
    check_map(0.02);
}
END_TEST

static Suite *suite(void)
{
    Suite *suite = suite_create("tam limits");
    TCase *tests = tcase_create("limits");
    tcase_add_checked_fixture(tests, map_begin, map_end);
    tcase_add_test(tests, plain_a_stroke_longer_than_the_tile_is_counted_three_times);
    tcase_add_test(tests, ours_a_stroke_longer_than_the_tile_inks_a_pixel_once);
    tcase_add_test(tests, plain_drawing_until_the_target_is_reached_overshoots);
    tcase_add_test(tests, ours_stops_before_a_stroke_that_increases_the_error);
    tcase_add_test(tests, plain_box_filtered_levels_lose_the_strokes);
    tcase_add_test(tests, plain_thin_ink_never_reaches_its_target);
    tcase_add_loop_test(tests, ours_ends_when_no_stroke_darkens_the_image, 0, 3);
    tcase_add_test(tests, no_tone_draws_no_stroke);
    tcase_add_loop_test(tests, one_level_one_tone_and_one_candidate_make_a_map, 0, MAP_STYLES);
    tcase_add_loop_test(tests, strokes_of_single_candidates_are_more_even_than_random_ones, 0, 2);
    tcase_add_test(tests, a_stroke_image_of_one_pixel_draws_bars);
    tcase_add_test(tests, strokes_with_empty_ends_are_placed_evenly);
    tcase_add_test(tests, a_stroke_wider_than_an_image_is_drawn_at_its_tone);
    tcase_add_test(tests, maps_are_made_at_the_limits_of_size);
    suite_add_tcase(suite, tests);
    return suite;
}
HATCH_TEST_MAIN(suite)
