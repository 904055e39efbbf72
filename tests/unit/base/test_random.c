#include "run.h"

#include <math.h>

#include "base/random.h"

/* The published sequence of SplitMix64 from seed 0 is the finaliser applied to the multiples of its gamma. */
START_TEST(mix_gives_the_published_sequence)
{
    static const uint64_t want[] = {0xe220a8397b1dcdafu, 0x6e789e6aa1b965f4u, 0x06c45d188009454fu};
    for (uint64_t i = 0; i < 3; i++)
        ck_assert_uint_eq(hatch_random_mix((i + 1) * 0x9e3779b97f4a7c15u), want[i]);
}
END_TEST

/* All outputs depend on these values: they must never change. */
START_TEST(numbers_never_change)
{
    ck_assert_uint_eq(hatch_random_u64(1, 0, 0), 0x32031582160b9745u);
    ck_assert_uint_eq(hatch_random_u64(1, 2, 3), 0xf57ac7261f7b0aabu);
    ck_assert_uint_eq(hatch_random_u64(UINT64_MAX, UINT64_MAX, UINT64_MAX), 0x74b735a75566e3a1u);
}
END_TEST

enum { CELLS = 256, DRAWS = CELLS * 400 };

/* Chi-square over 256 cells has mean 255 and standard deviation 22.6; eight deviations are allowed. */
static void check_uniform(const unsigned *counts)
{
    double chi_square = 0;
    for (int i = 0; i < CELLS; i++) {
        double difference = counts[i] - (double)DRAWS / CELLS;
        chi_square += difference * difference / ((double)DRAWS / CELLS);
    }
    ck_assert_double_lt(fabs(chi_square - (CELLS - 1)), 8 * sqrt(2 * (CELLS - 1)));
}

START_TEST(units_are_uniform_along_index_stream_and_seed)
{
    for (int along = 0; along < 3; along++) {
        unsigned counts[CELLS] = {0};
        for (uint64_t i = 0; i < DRAWS; i++) {
            float unit = hatch_random_unit(along == 0 ? i : 7, along == 1 ? i : 7, along == 2 ? i : 7);
            ck_assert(unit >= 0 && unit < 1);
            ck_assert(unit * 0x1p24f == floorf(unit * 0x1p24f));
            counts[(int)(unit * CELLS)]++;
        }
        check_uniform(counts);
    }
}
END_TEST

/* Pairs of the highest four bits for neighbouring values of each argument. */
START_TEST(neighbours_are_independent)
{
    for (int along = 0; along < 3; along++) {
        unsigned counts[CELLS] = {0};
        for (uint64_t i = 0; i < DRAWS; i++) {
            uint64_t a[3] = {5, 5, 5}, b[3] = {5, 5, 5};
            a[along] = i;
            b[along] = i + 1;
            counts[hatch_random_u64(a[0], a[1], a[2]) >> 60 << 4 | hatch_random_u64(b[0], b[1], b[2]) >> 60]++;
        }
        check_uniform(counts);
    }
}
END_TEST

static Suite *suite(void)
{
    Suite *suite = suite_create("base random");
    TCase *tests = tcase_create("random");
    tcase_add_test(tests, mix_gives_the_published_sequence);
    tcase_add_test(tests, numbers_never_change);
    tcase_add_test(tests, units_are_uniform_along_index_stream_and_seed);
    tcase_add_test(tests, neighbours_are_independent);
    suite_add_tcase(suite, tests);
    return suite;
}
HATCH_TEST_MAIN(suite)
