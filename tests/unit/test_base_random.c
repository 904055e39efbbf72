#include "run.h"

#include "base/random.h"

/* The published sequence of SplitMix64 from seed 0 is the finaliser of the multiples of its gamma. */
START_TEST(mix_makes_the_published_sequence)
{
    static const uint64_t want[] = {0xe220a8397b1dcdafu, 0x6e789e6aa1b965f4u, 0x06c45d188009454fu};
    for (uint64_t i = 0; i < 3; i++)
        ck_assert_uint_eq(hatch_random_mix((i + 1) * 0x9e3779b97f4a7c15u), want[i]);
}
END_TEST

static Suite *suite(void)
{
    Suite *suite = suite_create("base random");
    TCase *tests = tcase_create("random");
    tcase_add_test(tests, mix_makes_the_published_sequence);
    suite_add_tcase(suite, tests);
    return suite;
}
HATCH_TEST_MAIN(suite)
