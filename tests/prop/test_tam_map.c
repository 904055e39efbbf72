/* Properties of every tonal art map, for all styles, numbers of tones and random seeds. LONG=1 measures more seeds. */
#include <math.h>

#include "measure/tam_figures.h"
#include "tam_map.h"

static struct test_map map;

static struct hatch_tam_image_figures figures_of(uint32_t tone, uint32_t level)
{
    struct hatch_tam_image_figures figures;
    HATCH_TEST_OK(hatch_measure_tam_image(&map.tam, tone, level, &map_scratch, &figures, &map_err), &map_err);
    return figures;
}

static struct hatch_tam_strokes strokes_of(void)
{
    return (struct hatch_tam_strokes){&map.strokes, &map.style, &map.brush, map.options.growth};
}

static double stroke_darkness(uint32_t level)
{
    double darkness;
    struct hatch_tam_strokes strokes = strokes_of();
    HATCH_TEST_OK(hatch_measure_stroke_darkness(&map.tam, &strokes, level, &map_scratch, &darkness, &map_err),
                  &map_err);
    return darkness;
}

static void check_nesting(void)
{
    uint64_t missing = 1;
    struct hatch_tam_strokes strokes = strokes_of();
    HATCH_TEST_OK(hatch_measure_tam_nesting(&map.tam, &strokes, &map_scratch, &missing, &map_err), &map_err);
    ck_assert_uint_eq(missing, 0);
    for (uint32_t tone = 0; tone < map.tam.tones; tone++)
        for (uint32_t level = 0; level < map.tam.columns[tone].level_count; level++)
            ck_assert_uint_eq(figures_of(tone, level).lighter_pixels, 0);
}

/* For every style, 6 and 255 tones, of which one is with growth of strokes. */
START_TEST(strokes_nest_over_tones_and_levels)
{
    const int style = _i % MAP_STYLES, many = _i / MAP_STYLES;
    map_style(map_styles[style], "candidates 100 30", &map);
    map.options.tones = many ? 255 : 6;
    map.options.growth = (style + many) % 2 ? 0.5f : 0;
    map_fill(&map);
    check_nesting();
}
END_TEST

/* Checks errors of tone: up to 0.003 on the finest level and 0.02 on the others, or the darkness of a stroke if that is
 * more. */
static void check_tones(void)
{
    for (uint32_t level = 0; level < map.options.levels; level++) {
        double allowed = fmax(level ? 0.02 : 0.003, stroke_darkness(level));
        for (uint32_t tone = 0; tone < map.tam.tones; tone++) {
            double error = figures_of(tone, level).error;
            ck_assert_msg(fabs(error) <= allowed, "%s, tone %u, level %u: %g, allowed %g", map.style.name, tone, level,
                          error, allowed);
        }
    }
}

/* 256², the size in the paper, where 0.003 holds on the finest level for all strokes. */
START_TEST(tones_are_met_and_no_seam_is_visible)
{
    double seam[2] = {0, 0};
    map_style(map_styles[_i], NULL, &map);
    map.options.size_px = 256;
    map.options.levels = 4;
    map_fill(&map);
    check_tones();
    for (uint32_t tone = 0; tone < 6; tone++) {
        ck_assert_double_le(fabs(figures_of(tone, 0).error), 0.003);
        for (uint32_t level = 0; level < 4; level++) {
            struct hatch_tam_image_figures figures = figures_of(tone, level);
            seam[0] += figures.seam_z[0] / (6 * 4);
            seam[1] += figures.seam_z[1] / (6 * 4);
        }
    }
    ck_assert_double_lt(fabs(seam[0]), 2);
    ck_assert_double_lt(fabs(seam[1]), 2);
}
END_TEST

/* A stroke for a coarse image also darkens finer ones, which with many tones may be close to their targets. */
START_TEST(many_tones_are_met)
{
    map_style(map_styles[_i], "candidates 100 30", &map);
    map.options.size_px = 128;
    map.options.levels = 3;
    map.options.tones = 255;
    map_fill(&map);
    check_tones();
}
END_TEST

/* Without a seam the figure of an image is a random number of mean 0 and standard deviation 1: one in twenty is beyond
 * 2. A seam would move the mean over many random seeds. */
START_TEST(no_seam_is_visible_over_many_seeds)
{
    enum { SEEDS = 6, LEVELS = 2, IMAGES = SEEDS * LEVELS * 6 };
    double mean[2] = {0, 0};
    uint32_t far_out = 0;
    for (uint64_t seed = 1; seed <= SEEDS; seed++) {
        struct hatch_arena_mark mark = hatch_arena_mark(&map_arena);
        map_style(map_styles[_i], "candidates 100 30", &map);
        map.options.size_px = 128;
        map.options.levels = LEVELS;
        map.options.seed = seed;
        map_fill(&map);
        for (uint32_t tone = 0; tone < 6; tone++)
            for (uint32_t level = 0; level < LEVELS; level++)
                for (int axis = 0; axis < 2; axis++) {
                    double z = figures_of(tone, level).seam_z[axis];
                    mean[axis] += z / IMAGES;
                    far_out += fabs(z) >= 2;
                }
        hatch_arena_rewind(&map_arena, mark);
    }
    ck_assert_double_lt(fabs(mean[0]), 0.5);
    ck_assert_double_lt(fabs(mean[1]), 0.5);
    ck_assert_uint_lt(far_out, 2 * IMAGES / 10);
}
END_TEST

/* A stroke is drawn only if it brings the mean closer to the target, so no image is darker than its target by more than
 * half of the darkness of a stroke. The test uses the darkness of a mean stroke. */
START_TEST(no_random_seed_makes_images_too_dark)
{
    for (uint64_t seed = 1; seed <= 50; seed++) {
        struct hatch_arena_mark mark = hatch_arena_mark(&map_arena);
        map_style(map_styles[seed % MAP_STYLES], "candidates 60 20", &map);
        map.options.seed = seed;
        map_fill(&map);
        for (uint32_t level = 0; level < 2; level++) {
            double stroke = stroke_darkness(level);
            for (uint32_t tone = 0; tone < 6; tone++)
                ck_assert_msg(figures_of(tone, level).error <= stroke, "seed %d, tone %u, level %u: %g over by %g",
                              (int)seed, tone, level, figures_of(tone, level).error, stroke);
        }
        hatch_arena_rewind(&map_arena, mark);
    }
}
END_TEST

/* Adds the evenness of the finest images, averaged over tones, to sum. */
static void add_evenness(enum hatch_fill_method method, uint64_t seed, double *sum)
{
    double ratio[6 * HATCH_EVENNESS_BOXES];
    map_style("ink", NULL, &map);
    map.options.size_px = 256;
    map.options.levels = 4;
    map.options.method = method;
    map.options.seed = seed;
    map_fill(&map);
    struct hatch_tam_strokes strokes = strokes_of();
    HATCH_TEST_OK(hatch_measure_evenness(&map.tam, &strokes, 4, &map_scratch, ratio, &map_err), &map_err);
    for (uint32_t i = 0; i < 6 * HATCH_EVENNESS_BOXES; i++)
        sum[i % HATCH_EVENNESS_BOXES] += ratio[i] / 6;
}

/* Compares five random seeds with bounds, and as many as time allows with the exhaustive method of the paper. */
START_TEST(strokes_are_evenly_distributed)
{
    static const double bounds[HATCH_EVENNESS_BOXES] = {0.62, 0.56, 0.50, 0.40};
    uint64_t compared = getenv("LONG") ? 5 : 1;
    double sum[HATCH_EVENNESS_BOXES] = {0}, first[HATCH_EVENNESS_BOXES], paper[HATCH_EVENNESS_BOXES] = {0};
    for (uint64_t seed = 1; seed <= 5; seed++) {
        add_evenness(HATCH_FILL_FIELD, seed, sum);
        if (seed == compared)
            memcpy(first, sum, sizeof first);
        if (seed <= compared)
            add_evenness(HATCH_FILL_EXHAUSTIVE, seed, paper);
    }
    for (uint32_t box = 0; box < HATCH_EVENNESS_BOXES; box++) {
        ck_assert_msg(sum[box] / 5 <= bounds[box], "box N/%u: %g, want %g", hatch_evenness_divisors[box], sum[box] / 5,
                      bounds[box]);
        ck_assert_msg(first[box] <= paper[box], "box N/%u: %g, exhaustively %g", hatch_evenness_divisors[box],
                      first[box] / (double)compared, paper[box] / (double)compared);
    }
}
END_TEST

static Suite *suite(void)
{
    Suite *suite = suite_create("tonal art maps");
    TCase *tests = tcase_create("map");
    tcase_add_checked_fixture(tests, map_begin, map_end);
    tcase_add_loop_test(tests, strokes_nest_over_tones_and_levels, 0, 2 * MAP_STYLES);
    tcase_add_loop_test(tests, tones_are_met_and_no_seam_is_visible, 0, MAP_STYLES);
    tcase_add_loop_test(tests, many_tones_are_met, 0, MAP_STYLES);
    tcase_add_loop_test(tests, no_seam_is_visible_over_many_seeds, 0, MAP_STYLES);
    tcase_add_test(tests, no_random_seed_makes_images_too_dark);
    tcase_add_test(tests, strokes_are_evenly_distributed);
    suite_add_tcase(suite, tests);
    return suite;
}
HATCH_TEST_MAIN(suite)
