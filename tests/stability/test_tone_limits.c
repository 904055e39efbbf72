/* Maps on which threshold textures fail (Webb et al. 2002, §3.2): the plain_ tests show the failure and the figures
 * that tamthresh reports, the ours_ tests the remedy. */
#include <math.h>

#include "tam_made.h"
#include "measure/tone_figures.h"
#include "tam/exact.h"
#include "tam/thresholds.h"

#define WARNED 0.02 /* error above which tamthresh warns */

static struct hatch_thresholds made;
static const struct hatch_threshold_figures *const figures = &made.figures;

static void make(const struct hatch_tam *tam, uint32_t bins, const float *border)
{
    const struct hatch_threshold_options how = {.bins = bins, .border = border, .seed = 1};
    HATCH_TEST_OK(hatch_thresholds_make(tam, &how, NULL, &map_arena, &map_scratch, &made, &map_err), &map_err);
}

static float sample(const void *subject, float u, float v, float tone, float lod)
{
    return hatch_thresholds_sample(subject, u, v, tone, lod);
}

static float sample_exact(const void *subject, float u, float v, float tone, float lod)
{
    return hatch_exact_sample(subject, u, v, tone, lod);
}

static struct hatch_tone_figures measure(const struct hatch_tam *map, hatch_tone_sample sampler, const void *what,
                                         float lod)
{
    struct hatch_tone_figures found;
    const struct hatch_tone_test test = {map, sampler, what, lod, 20000};
    HATCH_TEST_OK(hatch_measure_tones(&test, NULL, &map_scratch, &found, &map_err), &map_err);
    return found;
}

static double exact_error(const struct hatch_tam *map)
{
    struct hatch_exact exact;
    HATCH_TEST_OK(hatch_exact_make(map, NULL, &map_arena, &map_scratch, &exact, &map_err), &map_err);
    return measure(map, sample_exact, &exact, 0.5f).error_max;
}

/* The number of greys of a texel over all tones, including white. */
static uint32_t count_greys(float u, float v)
{
    uint32_t count = 1;
    for (int i = 1; i <= 1000; i++) {
        float before = hatch_thresholds_sample(&made, u, v, (float)(i - 1) / 1000, 0);
        count += hatch_thresholds_sample(&made, u, v, (float)i / 1000, 0) != before;
    }
    return count;
}

/* 256 greys instead of strokes. */
START_TEST(plain_a_ramp_makes_seven_bands)
{
    struct hatch_tam ramp = made_map(64, 255, 1, "Y", made_ramp);
    make(&ramp, 7, NULL);
    for (int i = 0; i < 20; i++)
        ck_assert_uint_eq(count_greys(((float)i + 0.5f) / 64, ((float)(3 * i % 64) + 0.5f) / 64), 8);
    ck_assert_double_gt(figures->steps, 200);
    ck_assert_double_eq(figures->merged, 1);
    ck_assert_double_gt(figures->error, WARNED);
}
END_TEST

/* Random steps, with probabilities in proportion to their heights, dither the bands, so their mean tone is right; with
 * the middle of each bin it would be off by a quarter of a band. */
START_TEST(ours_the_bands_of_a_ramp_have_its_mean_tone)
{
    struct hatch_tam ramp = made_map(64, 255, 1, "Y", made_ramp);
    double worst = 0;
    make(&ramp, 7, NULL);
    for (int i = 5; i < 100; i++) {
        double sum = 0;
        float tone = (float)i / 100;
        for (uint32_t t = 0; t < 4096; t++)
            sum += (double)hatch_thresholds_sample(&made, ((float)(t % 64) + 0.5f) / 64, ((float)(t / 64) + 0.5f) / 64,
                                                   tone, 0);
        worst = fmax(worst, fabs(sum / 4096 - (1 - (double)tone)));
    }
    ck_assert_double_lt(worst, 0.012);
    ck_assert_double_lt(exact_error(&ramp), 1.0 / 255);
}
END_TEST

/* Hundreds of thin, faint, short strokes that darken each other: most texels change more often than there are bins. */
static void thin_strokes(struct test_map *map)
{
    map_style(NULL, "width 1\nlength 0.02 0.05\nink 0.3\noverlap darkens\ndarkest 1\ncandidates 5 5", map);
    map->options.tones = 255;
    map_fill(map);
}

START_TEST(plain_thin_strokes_overflow_the_bins)
{
    struct test_map map;
    thin_strokes(&map);
    make(&map.tam, 7, NULL);
    ck_assert_double_gt(figures->steps, 15);
    ck_assert_double_gt(figures->merged, 0.8);
    ck_assert_double_gt(figures->error, WARNED);
    double of_seven = figures->error;
    make(&map.tam, 3, NULL);
    ck_assert_double_gt(figures->error, 1.5 * of_seven);
}
END_TEST

START_TEST(ours_exact_runs_hold_thin_strokes)
{
    struct test_map map;
    thin_strokes(&map);
    ck_assert_double_lt(exact_error(&map.tam), 1.0 / 255);
    map_style("ink", "darkest 1\ncandidates 50 20", &map);
    map.options.tones = 255;
    map.options.size_px = 128;
    map_fill(&map);
    make(&map.tam, 7, NULL);
    ck_assert_double_lt(figures->error, WARNED / 4); /* ordinary strokes fit */
}
END_TEST

/* A stroke of tone .2 beside one of tone .8. */
static float side_by_side(float u, float v, uint32_t level, float tone, uint32_t channel)
{
    (void)v, (void)level, (void)channel;
    bool left = u > 0.25f && u<0.5f, right = u> 0.5f && u < 0.75f;
    return (left && tone > 0.2f) || (right && tone > 0.8f) ? 0 : 1;
}

/* In one bin, x is interpolated from .2 to .8 between the strokes, so that the border of the first stroke moves over
 * the texels of the second as the tone rises. */
START_TEST(plain_distant_steps_in_one_bin_move_the_border_of_a_stroke)
{
    struct hatch_tam map = made_map(64, 255, 1, "Y", side_by_side);
    make(&map, 1, NULL);
    float edge = 31.6f / 64; /* between texel centres of both strokes; the first has full ink for .1 of the way */
    ck_assert_float_eq(hatch_thresholds_sample(&made, edge, 0.5f, 0.22f, 0), 1);
    ck_assert_float_eq(hatch_thresholds_sample(&made, edge, 0.5f, 0.5f, 0), 0);
    ck_assert_double_gt(measure(&map, sample, &made, 0).error_max, 0.45);
}
END_TEST

START_TEST(ours_fitted_bins_separate_distant_steps)
{
    struct hatch_tam map = made_map(64, 255, 1, "Y", side_by_side);
    make(&map, 2, NULL);
    float edge = 31.6f / 64;
    for (int i = 0; i < 100; i++) {
        float tone = ((float)i + 0.5f) / 100, below = hatch_tone_sample_map(&map, edge, 0.5f, tone, 0);
        /* except at the columns in which the strokes appear */
        if (fabsf(tone - 0.2f) > 0.01f && fabsf(tone - 0.8f) > 0.01f)
            ck_assert_float_eq_tol(hatch_thresholds_sample(&made, edge, 0.5f, tone, 0), below, 0.005f);
    }
}
END_TEST

/* Levels of detail between two levels, where a texel may have a step on the coarser level only. */
START_TEST(ours_empty_texels_follow_the_coarser_level)
{
    struct test_map map;
    map_style("ink", "darkest 1\ncandidates 50 20", &map);
    map.options.tones = 255;
    map.options.size_px = 128;
    map.options.levels = 3;
    map_fill(&map);
    make(&map.tam, 7, NULL);
    double whole = measure(&map.tam, sample, &made, 0).error, half = measure(&map.tam, sample, &made, 0.5f).error;
    ck_assert_double_lt(whole, 0.006);
    ck_assert_double_lt(half, 0.016);
}
END_TEST

static Suite *suite(void)
{
    Suite *suite = suite_create("tone limits");
    TCase *tests = tcase_create("limits");
    tcase_add_checked_fixture(tests, map_begin, map_end);
    tcase_add_test(tests, plain_a_ramp_makes_seven_bands);
    tcase_add_test(tests, ours_the_bands_of_a_ramp_have_its_mean_tone);
    tcase_add_test(tests, plain_thin_strokes_overflow_the_bins);
    tcase_add_test(tests, ours_exact_runs_hold_thin_strokes);
    tcase_add_test(tests, plain_distant_steps_in_one_bin_move_the_border_of_a_stroke);
    tcase_add_test(tests, ours_fitted_bins_separate_distant_steps);
    tcase_add_test(tests, ours_empty_texels_follow_the_coarser_level);
    suite_add_tcase(suite, tests);
    return suite;
}
HATCH_TEST_MAIN(suite)
