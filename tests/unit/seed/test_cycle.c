#include "arenas.h"

#include <string.h>

#include "fail_alloc.h"
#include "seed/cycle/cycle.h"

static enum hatch_status make(enum hatch_cycle_method method, uint32_t count, uint64_t seed, uint8_t *crumbs,
                              struct hatch_err *error)
{
    const struct hatch_cycle_options options = {.method = method, .count = count, .seed = seed, .steps_max = 1000000};
    return hatch_cycle_make(&options, &scratch, crumbs, NULL, error);
}

/* Counts the windows of every length. */
static void check_uniform(const uint8_t *crumbs, uint32_t count)
{
    static uint32_t seen[1u << 22];
    for (uint32_t length = 1; (uint64_t)1 << 2 * (length - 1) <= count; length++) {
        uint32_t patterns = (uint32_t)1 << 2 * length, least = count / patterns;
        memset(seen, 0, sizeof *seen * patterns);
        for (uint32_t i = 0; i < count; i++) {
            uint32_t pattern = 0;
            for (uint32_t k = 0; k < length; k++)
                pattern = 4 * pattern + crumbs[(i + k) % count];
            seen[pattern]++;
        }
        uint32_t p = 0;
        while (p < patterns && (seen[p] == least || (seen[p] == least + 1 && count % patterns)))
            p++;
        ck_assert_msg(p == patterns, "%u: pattern %u of %u crumbs is not even", count, p, length);
    }
}

START_TEST(any_length_is_uniform_at_every_pattern_length)
{
    static uint8_t crumbs[2048];
    for (uint32_t count = 2; count <= 2048; count++) {
        memset(crumbs, 9, sizeof crumbs);
        HATCH_TEST_OK(make(HATCH_CYCLE_ANY, count, count, crumbs, &err), &err);
        uint32_t crumb = 0;
        while (crumb < count && crumbs[crumb] < 4)
            crumb++;
        ck_assert_uint_eq(crumb, count);
        check_uniform(crumbs, count);
    }
}
END_TEST

START_TEST(a_large_odd_length_is_uniform)
{
    static uint8_t crumbs[1000003];
    HATCH_TEST_OK(make(HATCH_CYCLE_ANY, 1000003, 5, crumbs, &err), &err);
    check_uniform(crumbs, 1000003);
}
END_TEST

START_TEST(powers_of_four_are_uniform_by_the_other_methods)
{
    static uint8_t crumbs[65536];
    for (uint32_t count = 4; count <= 65536; count *= 4) {
        HATCH_TEST_OK(make(HATCH_CYCLE_EULER, count, 3, crumbs, &err), &err);
        check_uniform(crumbs, count);
    }
    for (uint32_t count = 4; count <= 64; count *= 4) {
        HATCH_TEST_OK(make(HATCH_CYCLE_BACKTRACK, count, 3, crumbs, &err), &err);
        check_uniform(crumbs, count);
    }
}
END_TEST

static int compare(const void *a, const void *b)
{
    return memcmp(a, b, 4);
}

/* Uniform cycles of four crumbs are the 3! cyclic orders of 0 .. 3, equally likely. */
START_TEST(circuits_are_equally_likely)
{
    enum { DRAWS = 6000 };
    uint32_t seen[6] = {0};
    uint8_t known[6][4], crumbs[4], turned[4];
    uint32_t known_count = 0;
    for (uint32_t seed = 0; seed < DRAWS; seed++) {
        HATCH_TEST_OK(make(HATCH_CYCLE_EULER, 4, seed, crumbs, &err), &err);
        uint32_t zero = 0, kind = 0;
        while (crumbs[zero])
            zero++;
        for (uint32_t i = 0; i < 4; i++)
            turned[i] = crumbs[(zero + i) % 4];
        while (kind < known_count && compare(known[kind], turned))
            kind++;
        ck_assert_uint_lt(kind, 6);
        memcpy(known[kind], turned, 4);
        known_count += kind == known_count;
        seen[kind]++;
    }
    double chi_square = 0;
    for (int k = 0; k < 6; k++)
        chi_square += (seen[k] - DRAWS / 6.0) * (seen[k] - DRAWS / 6.0) / (DRAWS / 6.0);
    ck_assert_uint_eq(known_count, 6);
    ck_assert_double_lt(chi_square, 30); /* five degrees of freedom: 1.5e-5 */
}
END_TEST

START_TEST(random_seeds_determine_cycles)
{
    uint8_t first[61], second[61], again[61];
    HATCH_TEST_OK(make(HATCH_CYCLE_ANY, 61, 1, first, &err), &err);
    HATCH_TEST_OK(make(HATCH_CYCLE_ANY, 61, 2, second, &err), &err);
    HATCH_TEST_OK(make(HATCH_CYCLE_ANY, 61, 1, again, &err), &err);
    ck_assert_mem_eq(first, again, 61);
    ck_assert_mem_ne(first, second, 61);
}
END_TEST

START_TEST(backtracking_gives_up_at_its_limit)
{
    uint8_t crumbs[256];
    ck_assert_int_eq(make(HATCH_CYCLE_BACKTRACK, 256, 1, crumbs, &err), HATCH_LIMIT);
    ck_assert_str_eq(err.text, "backtracking found no seed set of 256 points: "
                               "allow more steps or use another method");
}
END_TEST

START_TEST(other_counts_than_powers_of_four_are_rejected_by_euler_and_backtrack)
{
    uint8_t crumbs[60];
    ck_assert_int_eq(make(HATCH_CYCLE_EULER, 60, 1, crumbs, &err), HATCH_USAGE);
    ck_assert_int_eq(make(HATCH_CYCLE_BACKTRACK, 60, 1, crumbs, &err), HATCH_USAGE);
}
END_TEST

static enum hatch_status make_for_allocation(void *context, struct hatch_arena *kept, struct hatch_arena *temporary,
                                             struct hatch_err *error)
{
    const struct hatch_cycle_options *options = context;
    uint8_t *crumbs = HATCH_NEW(kept, uint8_t, options->count, error);
    return crumbs ? hatch_cycle_make(options, temporary, crumbs, NULL, error) : HATCH_LIMIT;
}

START_TEST(every_failed_allocation_is_a_status)
{
    for (int method = HATCH_CYCLE_ANY; method <= HATCH_CYCLE_BACKTRACK; method++) {
        struct hatch_cycle_options options = {
            .method = (enum hatch_cycle_method)method, .count = 64, .steps_max = 100000};
        hatch_test_fail_alloc(make_for_allocation, &options, NULL, 0);
    }
}
END_TEST

START_TEST(backtracking_may_take_all_its_steps)
{
    struct hatch_cycle_options options = {
        .method = HATCH_CYCLE_BACKTRACK, .count = 64, .seed = 3, .steps_max = 1000000};
    uint8_t crumbs[64];
    uint64_t taken;
    HATCH_TEST_OK(hatch_cycle_make(&options, &scratch, crumbs, &taken, &err), &err);
    options.steps_max = taken;
    HATCH_TEST_OK(hatch_cycle_make(&options, &scratch, crumbs, &taken, &err), &err);
    options.steps_max = taken - 1;
    ck_assert_int_eq(hatch_cycle_make(&options, &scratch, crumbs, &taken, &err), HATCH_LIMIT);
}
END_TEST

static Suite *suite(void)
{
    Suite *suite = suite_create("seed cycle");
    TCase *tests = tcase_create("cycle");
    tcase_add_checked_fixture(tests, begin, end);
    tcase_add_test(tests, any_length_is_uniform_at_every_pattern_length);
    tcase_add_test(tests, a_large_odd_length_is_uniform);
    tcase_add_test(tests, powers_of_four_are_uniform_by_the_other_methods);
    tcase_add_test(tests, circuits_are_equally_likely);
    tcase_add_test(tests, random_seeds_determine_cycles);
    tcase_add_test(tests, backtracking_gives_up_at_its_limit);
    tcase_add_test(tests, other_counts_than_powers_of_four_are_rejected_by_euler_and_backtrack);
    tcase_add_test(tests, every_failed_allocation_is_a_status);
    tcase_add_test(tests, backtracking_may_take_all_its_steps);
    suite_add_tcase(suite, tests);
    return suite;
}

HATCH_TEST_MAIN(suite)
