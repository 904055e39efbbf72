#include "arenas.h"

#include <math.h>
#include <string.h>

#include "base/random.h"
#include "fail_alloc.h"
#include "measure/seed_figures.h"
#include "seed/seeds_make.h"
#include "seed/spread.h"

static enum hatch_status read_text(const char *text, struct hatch_seeds *seeds, struct hatch_err *error)
{
    return hatch_seeds_read((struct hatch_bytes){(const uint8_t *)text, strlen(text)}, &keep, seeds, error);
}

/* The cycle 0123: u = 0.0101... = 1/3, v = 0.0011... = 1/5, and its rotations. */
START_TEST(seed_points_are_periodic_fractions)
{
    static const double want[4][2] = {{1.0 / 3, 1.0 / 5}, {2.0 / 3, 2.0 / 5}, {1.0 / 3, 4.0 / 5}, {2.0 / 3, 3.0 / 5}};
    struct hatch_seeds seeds;
    struct hatch_seed_point points[4];
    HATCH_TEST_OK(read_text("0123\n", &seeds, &err), &err);
    hatch_seed_points(&seeds.layers[0], points);
    for (int i = 0; i < 4; i++) {
        ck_assert_double_eq_tol((double)points[i].u * 0x1p-64, want[i][0], 1e-15);
        ck_assert_double_eq_tol((double)points[i].v * 0x1p-64, want[i][1], 1e-15);
    }
}
END_TEST

START_TEST(a_file_is_read_as_it_was_written)
{
    struct hatch_seeds seeds, again;
    struct hatch_buffer file = {.arena = &keep};
    HATCH_TEST_OK(read_text("# first\n\n0123\r\n3021301\n#last", &seeds, &err), &err);
    ck_assert_uint_eq(seeds.layer_count, 2);
    ck_assert_uint_eq(seeds.layers[0].count, 4);
    ck_assert_uint_eq(seeds.layers[1].count, 7);
    HATCH_TEST_OK(hatch_seeds_write(&seeds, "why", &file, &err), &err);
    ck_assert_mem_eq(file.data, "# why\n0123\n3021301\n", file.size);
    HATCH_TEST_OK(hatch_seeds_read((struct hatch_bytes){file.data, file.size}, &keep, &again, &err), &err);
    ck_assert_mem_eq(again.layers[1].crumbs, seeds.layers[1].crumbs, 7);
}
END_TEST

START_TEST(a_bad_line_is_reported)
{
    static const struct {
        const char *text, *want;
    } bad[] = {{"0123\n0124\n", "line 2, column 4: want 0, 1, 2 or 3"},
               {"# a\n2\n", "line 2: a seed set of 1 digits, want 2 to 16777216"},
               {"# a\n", "the file has no seed set"},
               {"", "the file has no seed set"},
               {"0123\n3210", "line 2 has no end: the file is truncated"},
               {"01 2\n", "line 1, column 3: want 0, 1, 2 or 3"}};
    struct hatch_seeds seeds;
    for (size_t i = 0; i < sizeof bad / sizeof *bad; i++) {
        ck_assert_int_eq(read_text(bad[i].text, &seeds, &err), HATCH_BAD_INPUT);
        ck_assert_str_eq(err.text, bad[i].want);
    }
}
END_TEST

/* Distances across the edge of the tile. */
START_TEST(distances_wrap_around_the_tile)
{
    const uint64_t near_end = UINT64_MAX - (UINT64_MAX >> 5); /* 31/32 */
    struct hatch_seed_point points[3] = {{0, 0}, {near_end, 0}, {(uint64_t)1 << 63, 0}};
    double distance;
    HATCH_TEST_OK(hatch_spread_distance(points, 3, &scratch, &distance, &err), &err);
    ck_assert_double_eq_tol(distance, 1.0 / 32, 1e-12);
    ck_assert_double_eq_tol(hatch_spread_bound(1), sqrt(2 / sqrt(3)), 1e-12);
}
END_TEST

static void random_points(uint32_t count, struct hatch_seed_point *points)
{
    for (uint32_t i = 0; i < count; i++) {
        points[i].u = hatch_random_u64(7, count, 2 * (uint64_t)i);
        points[i].v = hatch_random_u64(7, count, 2 * (uint64_t)i + 1);
    }
}

/* Compares with all pairs of random points. */
START_TEST(the_smallest_distance_is_that_of_all_pairs)
{
    static struct hatch_seed_point points[500];
    for (uint32_t count = 2; count <= 500; count += 7) {
        double best = 1, distance;
        random_points(count, points);
        for (uint32_t i = 0; i < count; i++)
            for (uint32_t k = 0; k < i; k++)
                best = fmin(best, hypot((double)(int64_t)(points[i].u - points[k].u) * 0x1p-64,
                                        (double)(int64_t)(points[i].v - points[k].v) * 0x1p-64));
        HATCH_TEST_OK(hatch_spread_distance(points, count, &scratch, &distance, &err), &err);
        ck_assert_double_eq_tol(distance, best, 1e-12);
    }
}
END_TEST

/* A point at (1/2, 1/2): the closed box up to it is a quarter of the tile and contains it. A point at the origin is in
 * every box. */
START_TEST(discrepancy_of_one_point_is_known)
{
    struct hatch_seed_point middle = {(uint64_t)1 << 63, (uint64_t)1 << 63}, corner = {0, 0};
    double discrepancy;
    HATCH_TEST_OK(hatch_spread_discrepancy(&middle, 1, &scratch, &discrepancy, &err), &err);
    ck_assert_double_eq_tol(discrepancy, 0.75, 1e-12);
    HATCH_TEST_OK(hatch_spread_discrepancy(&corner, 1, &scratch, &discrepancy, &err), &err);
    ck_assert_double_eq_tol(discrepancy, 1.0, 1e-12);
}
END_TEST

/* Returns by how much the share of the points in a box from the origin differs from its area, with its upper sides or
 * without them. */
static double box_difference(const struct hatch_seed_point *points, uint32_t count, double u, double v)
{
    double open = 0, closed = 0;
    for (uint32_t i = 0; i < count; i++) {
        double x = (double)points[i].u * 0x1p-64, y = (double)points[i].v * 0x1p-64;
        open += x < u && y < v;
        closed += x <= u && y <= v;
    }
    return fmax(u * v - open / count, closed / count - u * v);
}

/* Compares with all boxes whose upper sides go through points or are those of the tile. */
START_TEST(discrepancy_is_that_of_all_boxes)
{
    struct hatch_seed_point points[20];
    for (uint32_t count = 1; count <= 20; count++) {
        double worst = 0, discrepancy;
        random_points(count, points);
        for (uint32_t i = 0; i <= count; i++)
            for (uint32_t k = 0; k <= count; k++)
                worst = fmax(worst, box_difference(points, count, i < count ? (double)points[i].u * 0x1p-64 : 1,
                                                   k < count ? (double)points[k].v * 0x1p-64 : 1));
        HATCH_TEST_OK(hatch_spread_discrepancy(points, count, &scratch, &discrepancy, &err), &err);
        ck_assert_double_eq_tol(discrepancy, worst, 1e-12);
    }
}
END_TEST

static void make(uint32_t count, uint32_t layers, uint32_t candidates, struct hatch_seeds *seeds)
{
    const struct hatch_seeds_options options = {
        .cycle = {.count = count, .seed = 3}, .layers = layers, .candidates = candidates};
    uint64_t steps;
    HATCH_TEST_OK(hatch_seeds_make(&options, &keep, &scratch, seeds, &steps, &err), &err);
}

START_TEST(sets_nest_exactly_and_are_even)
{
    struct hatch_seeds seeds;
    struct hatch_seed_figures figures;
    for (uint32_t count = 2; count <= 300; count += count < 20 ? 1 : 37) {
        make(count, 2, 5, &seeds);
        for (int layer = 0; layer < 2; layer++) {
            HATCH_TEST_OK(hatch_measure_seeds(&seeds.layers[layer], 1, &scratch, &figures, &err), &err);
            ck_assert_uint_eq(figures.uneven, 0);
            ck_assert_uint_eq(figures.astray, 0);
            ck_assert_double_eq_tol(figures.distance, figures.distance_sparse, 1e-9);
        }
    }
}
END_TEST

/* Two points at u = 1/3 and 2/3, v = 0. The rings of 1/4 and 1/2 end before length 1; that of 3/4 has (1, 0) and (0,
 * 1), where the powers are 1/2 and 2; that of 1 has (1, 1) and (1, -1). Then points on a diagonal. */
START_TEST(figures_of_nothing_are_not_numbers)
{
    struct hatch_seeds seeds;
    struct hatch_seed_figures figures;
    HATCH_TEST_OK(read_text("01\n", &seeds, &err), &err);
    HATCH_TEST_OK(hatch_measure_seeds(&seeds.layers[0], 1, &scratch, &figures, &err), &err);
    ck_assert(isnan(figures.correlation));
    ck_assert(isnan(figures.power[0]) && isnan(figures.power[1]));
    ck_assert_double_eq_tol(figures.power[2], 1.25, 1e-12);
    ck_assert_double_eq_tol(figures.power[3], 0.5, 1e-12);
    HATCH_TEST_OK(read_text("0303\n", &seeds, &err), &err);
    HATCH_TEST_OK(hatch_measure_seeds(&seeds.layers[0], 1, &scratch, &figures, &err), &err);
    ck_assert_double_eq_tol(figures.correlation, 1, 1e-12);
}
END_TEST

/* A cycle with two crumbs exchanged still nests, as every cycle does, but is not uniform. */
START_TEST(an_uneven_set_is_detected)
{
    struct hatch_seeds seeds;
    struct hatch_seed_figures figures;
    HATCH_TEST_OK(read_text("0012202332131130\n", &seeds, &err), &err);
    HATCH_TEST_OK(hatch_measure_seeds(&seeds.layers[0], 1, &scratch, &figures, &err), &err);
    ck_assert_uint_gt(figures.uneven, 0);
    HATCH_TEST_OK(read_text("0012202332131103\n", &seeds, &err), &err); /* example of the paper, §4.1 */
    HATCH_TEST_OK(hatch_measure_seeds(&seeds.layers[0], 1, &scratch, &figures, &err), &err);
    ck_assert_uint_eq(figures.uneven, 0);
}
END_TEST

START_TEST(more_candidates_spread_seed_points_better)
{
    struct hatch_seeds few, many;
    double within[2], together[2];
    make(64, 4, 1, &few);
    make(64, 4, 300, &many);
    HATCH_TEST_OK(hatch_seeds_spread(&few, &scratch, &within[0], &together[0], &err), &err);
    HATCH_TEST_OK(hatch_seeds_spread(&many, &scratch, &within[1], &together[1], &err), &err);
    ck_assert_double_gt(within[1], within[0]);
    ck_assert_double_gt(within[1], 3 * 0.083); /* of random points */
    ck_assert_double_gt(together[1], 2 * together[0]);
}
END_TEST

START_TEST(candidates_share_the_steps_of_searches)
{
    const uint64_t steps_max = 200000;
    for (uint64_t seed = 1; seed <= 4; seed++) {
        struct hatch_seeds_options options = {
            .cycle = {.method = HATCH_CYCLE_BACKTRACK, .count = 64, .seed = seed, .steps_max = steps_max},
            .layers = 2,
            .candidates = 100};
        struct hatch_seeds seeds;
        struct hatch_seed_figures figures;
        uint64_t steps;
        HATCH_TEST_OK(hatch_seeds_make(&options, &keep, &scratch, &seeds, &steps, &err), &err);
        ck_assert_uint_ge(steps, 2 * 100 * 61);
        ck_assert_uint_le(steps, 2 * (steps_max + 100));
        HATCH_TEST_OK(hatch_measure_seeds(&seeds.layers[1], 1, &scratch, &figures, &err), &err);
        ck_assert_uint_eq(figures.uneven, 0);
        options.cycle.steps_max = 60;
        ck_assert_int_eq(hatch_seeds_make(&options, &keep, &scratch, &seeds, &steps, &err), HATCH_LIMIT);
    }
}
END_TEST

/* One point more than can be counted is too many; as many as can be counted need more memory than there is. */
START_TEST(too_many_seed_points_are_refused)
{
    struct hatch_seed_set layers[2] = {{.count = UINT32_MAX}, {.count = 1}};
    struct hatch_seeds seeds = {.layers = layers};
    double within, together;
    for (seeds.layer_count = 1; seeds.layer_count <= 2; seeds.layer_count++) {
        ck_assert_int_eq(hatch_seeds_spread(&seeds, &scratch, &within, &together, &err), HATCH_LIMIT);
        ck_assert_int_eq(!!strstr(err.text, "2^32"), seeds.layer_count == 2);
    }
}
END_TEST

static enum hatch_status make_and_measure(void *context, struct hatch_arena *results, struct hatch_arena *temporary,
                                          struct hatch_err *error)
{
    const struct hatch_seeds_options options = {.cycle = {.count = 20, .seed = 3}, .layers = 2, .candidates = 2};
    struct hatch_seeds seeds;
    uint64_t steps;
    double within, together;
    HATCH_TRY(hatch_seeds_make(&options, results, temporary, &seeds, &steps, error));
    HATCH_TRY(hatch_seeds_spread(&seeds, temporary, &within, &together, error));
    return hatch_measure_seeds(&seeds.layers[0], 2, temporary, context, error);
}

START_TEST(every_failed_allocation_is_a_status)
{
    struct hatch_seed_figures figures = {0};
    hatch_test_fail_alloc(make_and_measure, &figures, &figures, sizeof figures);
}
END_TEST

static Suite *suite(void)
{
    Suite *suite = suite_create("seed sets");
    TCase *tests = tcase_create("seeds");
    tcase_add_checked_fixture(tests, begin, end);
    tcase_add_test(tests, seed_points_are_periodic_fractions);
    tcase_add_test(tests, a_file_is_read_as_it_was_written);
    tcase_add_test(tests, a_bad_line_is_reported);
    tcase_add_test(tests, distances_wrap_around_the_tile);
    tcase_add_test(tests, the_smallest_distance_is_that_of_all_pairs);
    tcase_add_test(tests, discrepancy_of_one_point_is_known);
    tcase_add_test(tests, discrepancy_is_that_of_all_boxes);
    tcase_add_test(tests, sets_nest_exactly_and_are_even);
    tcase_add_test(tests, figures_of_nothing_are_not_numbers);
    tcase_add_test(tests, an_uneven_set_is_detected);
    tcase_add_test(tests, more_candidates_spread_seed_points_better);
    tcase_add_test(tests, too_many_seed_points_are_refused);
    tcase_add_test(tests, candidates_share_the_steps_of_searches);
    tcase_add_test(tests, every_failed_allocation_is_a_status);
    suite_add_tcase(suite, tests);
    return suite;
}

HATCH_TEST_MAIN(suite)
