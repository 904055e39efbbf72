#include "arenas.h"

#include <math.h>
#include <string.h>

#include "base/random.h"
#include "fail_alloc.h"
#include "measure/seed_figures.h"
#include "seed/spread.h"

static enum hatch_status read_text(const char *text, struct hatch_seeds *seeds, struct hatch_err *said)
{
    return hatch_seeds_read((struct hatch_bytes){(const uint8_t *)text, strlen(text)}, &keep, seeds, said);
}

/* 0123 for ever: u = 0.0101... = 1/3, v = 0.0011... = 1/5, and the same turned. */
START_TEST(seeds_stand_at_periodic_fractions)
{
    static const double want[4][2] = {{1.0 / 3, 1.0 / 5}, {2.0 / 3, 2.0 / 5}, {1.0 / 3, 4.0 / 5}, {2.0 / 3, 3.0 / 5}};
    struct hatch_seeds seeds;
    struct hatch_seed_place places[4];
    HATCH_TEST_OK(read_text("0123\n", &seeds, &err), &err);
    hatch_seed_places(&seeds.layers[0], places);
    for (int i = 0; i < 4; i++) {
        ck_assert_double_eq_tol((double)places[i].u * 0x1p-64, want[i][0], 1e-15);
        ck_assert_double_eq_tol((double)places[i].v * 0x1p-64, want[i][1], 1e-15);
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

START_TEST(what_is_no_seed_set_is_named_by_its_line)
{
    static const struct {
        const char *text, *want;
    } bad[] = {{"0123\n0124\n", "line 2, column 4: not a crumb, which is 0, 1, 2 or 3"},
               {"# a\n2\n", "line 2: a cycle of 1 crumbs, want 2 to 16777216"},
               {"# a\n", "no seed set in it"},
               {"", "no seed set in it"},
               {"0123\n3210", "line 2 does not end: the file is cut"},
               {"01 2\n", "line 1, column 3: not a crumb, which is 0, 1, 2 or 3"}};
    struct hatch_seeds seeds;
    for (size_t i = 0; i < sizeof bad / sizeof *bad; i++) {
        ck_assert_int_eq(read_text(bad[i].text, &seeds, &err), HATCH_BAD_INPUT);
        ck_assert_str_eq(err.text, bad[i].want);
    }
}
END_TEST

/* Halves and quarters, across the tile's edges. */
START_TEST(distances_go_around_the_tile)
{
    const uint64_t near_end = UINT64_MAX - (UINT64_MAX >> 5); /* 31/32 */
    struct hatch_seed_place places[3] = {{0, 0}, {near_end, 0}, {(uint64_t)1 << 63, 0}};
    double distance;
    HATCH_TEST_OK(hatch_spread_distance(places, 3, &scratch, &distance, &err), &err);
    ck_assert_double_eq_tol(distance, 1.0 / 32, 1e-12);
    ck_assert_double_eq_tol(hatch_spread_bound(1), sqrt(2 / sqrt(3)), 1e-12);
}
END_TEST

/* Every pair, for random points: the grid of cells must find the same. */
START_TEST(distances_are_those_of_all_pairs)
{
    static struct hatch_seed_place places[500];
    for (uint32_t count = 2; count <= 500; count += 7) {
        double best = 1, distance;
        for (uint32_t i = 0; i < count; i++) {
            places[i].u = hatch_random_u64(7, count, 2 * (uint64_t)i);
            places[i].v = hatch_random_u64(7, count, 2 * (uint64_t)i + 1);
            for (uint32_t k = 0; k < i; k++)
                best = fmin(best, hypot((double)(int64_t)(places[i].u - places[k].u) * 0x1p-64,
                                        (double)(int64_t)(places[i].v - places[k].v) * 0x1p-64));
        }
        HATCH_TEST_OK(hatch_spread_distance(places, count, &scratch, &distance, &err), &err);
        ck_assert_double_eq_tol(distance, best, 1e-12);
    }
}
END_TEST

/* One point at (1/2, 1/2): the closed box up to it is a quarter of the tile and holds everything. One at the
 * origin is in every box, however small. */
START_TEST(discrepancy_of_one_point_is_known)
{
    struct hatch_seed_place middle = {(uint64_t)1 << 63, (uint64_t)1 << 63}, corner = {0, 0};
    double discrepancy;
    HATCH_TEST_OK(hatch_spread_discrepancy(&middle, 1, &scratch, &discrepancy, &err), &err);
    ck_assert_double_eq_tol(discrepancy, 0.75, 1e-12);
    HATCH_TEST_OK(hatch_spread_discrepancy(&corner, 1, &scratch, &discrepancy, &err), &err);
    ck_assert_double_eq_tol(discrepancy, 1.0, 1e-12);
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

/* A cycle with two crumbs exchanged nests still, for any cycle does, but is not even. */
START_TEST(an_uneven_set_is_found_out)
{
    struct hatch_seeds seeds;
    struct hatch_seed_figures figures;
    HATCH_TEST_OK(read_text("0012202332131130\n", &seeds, &err), &err);
    HATCH_TEST_OK(hatch_measure_seeds(&seeds.layers[0], 1, &scratch, &figures, &err), &err);
    ck_assert_uint_gt(figures.uneven, 0);
    HATCH_TEST_OK(read_text("0012202332131103\n", &seeds, &err), &err); /* the paper's, §4.1 */
    HATCH_TEST_OK(hatch_measure_seeds(&seeds.layers[0], 1, &scratch, &figures, &err), &err);
    ck_assert_uint_eq(figures.uneven, 0);
}
END_TEST

START_TEST(more_candidates_spread_seeds_better)
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

static enum hatch_status make_and_measure(void *context, struct hatch_arena *results, struct hatch_arena *temporary,
                                          struct hatch_err *said)
{
    const struct hatch_seeds_options options = {.cycle = {.count = 20, .seed = 3}, .layers = 2, .candidates = 2};
    struct hatch_seeds seeds;
    uint64_t steps;
    double within, together;
    HATCH_TRY(hatch_seeds_make(&options, results, temporary, &seeds, &steps, said));
    HATCH_TRY(hatch_seeds_spread(&seeds, temporary, &within, &together, said));
    return hatch_measure_seeds(&seeds.layers[0], 2, temporary, context, said);
}

START_TEST(every_failed_allocation_is_survived)
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
    tcase_add_test(tests, seeds_stand_at_periodic_fractions);
    tcase_add_test(tests, a_file_is_read_as_it_was_written);
    tcase_add_test(tests, what_is_no_seed_set_is_named_by_its_line);
    tcase_add_test(tests, distances_go_around_the_tile);
    tcase_add_test(tests, distances_are_those_of_all_pairs);
    tcase_add_test(tests, discrepancy_of_one_point_is_known);
    tcase_add_test(tests, sets_nest_exactly_and_are_even);
    tcase_add_test(tests, an_uneven_set_is_found_out);
    tcase_add_test(tests, more_candidates_spread_seeds_better);
    tcase_add_test(tests, every_failed_allocation_is_survived);
    suite_add_tcase(suite, tests);
    return suite;
}

HATCH_TEST_MAIN(suite)
