#include "tam_made.h"

#include <math.h>

#include "fail_alloc.h"
#include "measure/tone_figures.h"

static struct hatch_tone_figures figures;

static void measure(const struct hatch_tam *map, hatch_tone_sample sample, const void *subject, float lod)
{
    const struct hatch_tone_test test = {map, sample, subject, lod, 64000};
    HATCH_TEST_OK(hatch_measure_tones(&test, NULL, &map_scratch, &figures, &map_err), &map_err);
}

static float darker_by_a_tenth(const void *subject, float u, float v, float tone, float lod)
{
    return hatch_tone_sample_map(subject, u, v, tone, lod) - 0.1f;
}

static float half_grey(const void *subject, float u, float v, float tone, float lod)
{
    (void)subject, (void)v, (void)tone, (void)lod;
    return u < 0.25f ? 0.5f : u < 0.5f ? 0 : 1;
}

static float paper(float u, float v, uint32_t level, float tone, uint32_t channel)
{
    (void)u, (void)v, (void)level, (void)tone, (void)channel;
    return 1;
}

static float stripe(float u, float v, uint32_t level, float tone, uint32_t channel)
{
    (void)v, (void)level, (void)channel;
    return u < tone ? 0 : 1;
}

START_TEST(a_map_has_no_error_against_itself)
{
    struct hatch_tam map = made_map(64, 64, 1, _i ? "RGB" : "Y", stripe);
    measure(&map, hatch_tone_sample_map, &map, 0.5f * (float)_i);
    ck_assert_double_eq_tol(figures.error_max, 0, 1e-6);
    ck_assert_double_eq_tol(figures.tone_worst, 0, 1e-6);
}
END_TEST

START_TEST(a_constant_error_is_measured)
{
    struct hatch_tam map = made_map(64, 64, 1, "Y", made_ramp);
    measure(&map, darker_by_a_tenth, &map, 1);
    ck_assert_double_eq_tol(figures.tone_error, 0.1, 1e-5);
    ck_assert_double_eq_tol(figures.tone_worst, 0.1, 1e-5);
    ck_assert_double_eq_tol(figures.error, 0.1, 1e-5);
    ck_assert_double_eq_tol(figures.error_max, 0.1, 1e-5);
}
END_TEST

START_TEST(shares_of_grey_are_measured)
{
    struct hatch_tam map = made_map(64, 64, 1, "Y", paper);
    measure(&map, half_grey, &map, 0);
    ck_assert_double_eq_tol(figures.grey, 0.5, 0.01); /* half of the inked samples */
    ck_assert_double_eq_tol(figures.grey_all, 0.5, 0.01);
    ck_assert_double_eq_tol(figures.error, 0.375, 0.01);
    struct hatch_tam ramp = made_map(64, 255, 1, "Y", made_ramp);
    measure(&ramp, hatch_tone_sample_map, &ramp, 0);
    ck_assert_double_eq(figures.grey, 0); /* the map itself is grey there */
    ck_assert_double_eq_tol(figures.grey_all, 0.8 / 0.9, 0.02);
}
END_TEST

/* Blending few columns makes grey strokes: between two of four columns a stripe of a quarter tile is grey where
 * its darkness is 0.1 to 0.9. */
START_TEST(few_columns_make_grey_strokes)
{
    static struct hatch_mipmap columns[4];
    struct hatch_tam map = made_map(64, 64, 1, "Y", stripe), few = map;
    for (uint32_t i = 0; i < 4; i++) {
        columns[i] = map.columns[16 * i + 15];
        few.target[i] = map.target[16 * i + 15];
    }
    few.columns = columns;
    few.tones = 4;
    measure(&map, hatch_tone_sample_map, &few, 0);
    ck_assert_double_lt(figures.tone_worst, 0.02);
    ck_assert_double_gt(figures.grey, 0.2);
    double of_few = figures.grey;
    measure(&map, hatch_tone_sample_map, &map, 0);
    ck_assert_double_lt(figures.grey, of_few / 5);
}
END_TEST

START_TEST(the_result_does_not_depend_on_threads)
{
    struct hatch_pool *pool;
    struct hatch_tam map = made_map(64, 64, 1, "Y", stripe);
    measure(&map, half_grey, &map, 0);
    struct hatch_tone_figures alone = figures;
    HATCH_TEST_OK(hatch_pool_make(3, &map_arena, &pool, &map_err), &map_err);
    const struct hatch_tone_test test = {&map, half_grey, &map, 0, 64000};
    HATCH_TEST_OK(hatch_measure_tones(&test, pool, &map_scratch, &figures, &map_err), &map_err);
    hatch_pool_free(pool);
    ck_assert(memcmp(&alone, &figures, sizeof alone) == 0);
}
END_TEST

static enum hatch_status measure_again(void *context, struct hatch_arena *keep, struct hatch_arena *scratch,
                                       struct hatch_err *err)
{
    (void)keep;
    const struct hatch_tone_test test = {context, half_grey, context, 0, 64};
    return hatch_measure_tones(&test, NULL, scratch, &figures, err);
}

START_TEST(every_failed_allocation_is_a_limit)
{
    struct hatch_tam map = made_map(64, 4, 1, "Y", stripe);
    hatch_test_fail_alloc(measure_again, &map, &figures, sizeof figures);
}
END_TEST

static Suite *suite(void)
{
    Suite *suite = suite_create("measure tones");
    TCase *tests = tcase_create("tones");
    tcase_add_checked_fixture(tests, map_begin, map_end);
    tcase_add_loop_test(tests, a_map_has_no_error_against_itself, 0, 2);
    tcase_add_test(tests, a_constant_error_is_measured);
    tcase_add_test(tests, shares_of_grey_are_measured);
    tcase_add_test(tests, few_columns_make_grey_strokes);
    tcase_add_test(tests, the_result_does_not_depend_on_threads);
    tcase_add_test(tests, every_failed_allocation_is_a_limit);
    suite_add_tcase(suite, tests);
    return suite;
}
HATCH_TEST_MAIN(suite)
