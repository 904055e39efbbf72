#include "run.h"

#include <math.h>
#include <string.h>

#include "plan/plan.h"

static struct hatch_err err;

/* Two techniques that are useful, one that is slower and larger than the first, and a copy of the second. */
static const struct hatch_plan_figures four[] = {
    {10, 1e6, 1, 0.05},
    {20, 2e6, 2, 0.02},
    {11, 1e6, 1, 0.05},
    {20, 2e6, 2, 0.02},
};

START_TEST(a_budget_sets_what_it_names)
{
    struct hatch_plan_figures limits = hatch_plan_no_limits();
    HATCH_TEST_OK(hatch_plan_parse_budget("ms=10 mb=4.5", &limits, &err), &err);
    ck_assert_double_eq(limits.ms, 10);
    ck_assert_double_eq(limits.bytes, 4.5e6);
    ck_assert(isinf(limits.setup_s) && isinf(limits.error));
    HATCH_TEST_OK(hatch_plan_parse_budget(" s=0,", &limits, &err), &err);
    ck_assert_double_eq(limits.setup_s, 0);
    ck_assert_double_eq(limits.ms, 10);
}
END_TEST

START_TEST(other_budgets_are_refused_and_change_nothing)
{
    static const char *const wrong[] = {"",        " ",        "ms",    "ms=",   "ms=x",   "ms=-1",
                                        "ms=nan",  "ms=1e999", "ms =1", "kb=10", "ms=1;s", "ms=1 ms=2",
                                        "ms=1 =2", "mss=1",    "m=1",   "ms=0x1"};
    for (size_t i = 0; i < sizeof wrong / sizeof *wrong; i++) {
        struct hatch_plan_figures limits = hatch_plan_no_limits();
        ck_assert_msg(hatch_plan_parse_budget(wrong[i], &limits, &err) == HATCH_USAGE, "'%s'", wrong[i]);
        ck_assert_msg(isinf(limits.ms) && isinf(limits.bytes) && isinf(limits.setup_s), "'%s'", wrong[i]);
    }
}
END_TEST

START_TEST(the_worst_figure_is_the_excess)
{
    struct hatch_plan_figures limits = hatch_plan_no_limits();
    struct hatch_plan_worst worst;
    ck_assert_double_eq(hatch_plan_excess(&four[0], &limits, NULL), 0);
    limits = (struct hatch_plan_figures){20, 1e6, 0.25, 0.025};
    ck_assert_double_eq(hatch_plan_excess(&four[0], &limits, &worst), 4);
    ck_assert_str_eq(worst.name, "s");
    ck_assert_double_eq(worst.value, 1);
    limits.setup_s = INFINITY;
    ck_assert_double_eq_tol(hatch_plan_excess(&four[0], &limits, &worst), 2, 1e-12);
    ck_assert_str_eq(worst.name, "of tone error");
    const struct hatch_plan_figures free = {1, 0, 0, 0};
    limits = (struct hatch_plan_figures){2, 0, 0, 0};
    ck_assert_double_eq(hatch_plan_excess(&free, &limits, NULL), 0.5);
    ck_assert(isinf(hatch_plan_excess(&four[0], &limits, NULL)));
}
END_TEST

START_TEST(the_front_leaves_out_what_another_one_covers)
{
    bool useful[4];
    hatch_plan_front(four, 4, useful);
    ck_assert(useful[0] && useful[1] && !useful[2]);
    ck_assert_msg(!useful[3], "of equal ones, the first is useful");
    hatch_plan_front(four + 2, 2, useful);
    ck_assert(useful[0] && useful[1]);
    hatch_plan_front(four, 0, useful);
}
END_TEST

/* Each candidate is best in one figure: all are useful, in any order. */
START_TEST(no_figure_is_left_out_of_the_front)
{
    struct hatch_plan_figures each[4];
    bool useful[4];
    for (int i = 0; i < 4; i++)
        each[i] = (struct hatch_plan_figures){i != 0, i != 1, i != 2, i != 3};
    hatch_plan_front(each, 4, useful);
    for (int i = 0; i < 4; i++)
        ck_assert(useful[i]);
}
END_TEST

START_TEST(with_a_tolerance_the_fastest_is_chosen)
{
    struct hatch_plan_figures limits = hatch_plan_no_limits();
    limits.error = 0.06;
    ck_assert_uint_eq(hatch_plan_choose(four, 4, &limits), 0);
    limits.error = 0.03;
    ck_assert_uint_eq(hatch_plan_choose(four, 4, &limits), 1);
    limits.bytes = 1.5e6;
    ck_assert_uint_eq(hatch_plan_choose(four, 4, &limits), 4);
    ck_assert_uint_eq(hatch_plan_nearest(four, 4, &limits), 1);
    limits.bytes = 1e6;
    ck_assert_uint_eq(hatch_plan_nearest(four, 4, &limits), 0);
}
END_TEST

START_TEST(with_a_budget_alone_the_most_exact_is_chosen)
{
    struct hatch_plan_figures limits = hatch_plan_no_limits();
    limits.ms = 20;
    ck_assert_uint_eq(hatch_plan_choose(four, 4, &limits), 1);
    limits.ms = 19;
    ck_assert_uint_eq(hatch_plan_choose(four, 4, &limits), 0);
    limits.ms = 9;
    ck_assert_uint_eq(hatch_plan_choose(four, 4, &limits), 4);
    ck_assert_uint_eq(hatch_plan_nearest(four, 4, &limits), 0);
    ck_assert_uint_eq(hatch_plan_choose(four, 0, &limits), 0);
}
END_TEST

/* Over a limit of 0, no figure is a multiple of it: then the figures themselves are compared. */
START_TEST(over_a_limit_of_0_the_least_figure_is_nearest)
{
    struct hatch_plan_figures limits = hatch_plan_no_limits();
    struct hatch_plan_worst worst;
    limits.error = 0;
    ck_assert_uint_eq(hatch_plan_nearest(four, 4, &limits), 1);
    ck_assert(hatch_plan_is_nearer(&four[1], &four[0], &limits) && !hatch_plan_is_nearer(&four[0], &four[1], &limits));
    ck_assert(!hatch_plan_is_nearer(&four[1], &four[3], &limits));
    ck_assert(isinf(hatch_plan_excess(&four[1], &limits, &worst)));
    ck_assert_str_eq(worst.name, "of tone error");
    ck_assert_double_eq(worst.value, 0.02);
    const struct hatch_plan_figures exact = {1000, 9e6, 9, 0};
    limits.ms = 1;
    ck_assert_msg(hatch_plan_is_nearer(&exact, &four[1], &limits), "1000 times a limit is less than none of 0");
    limits.bytes = 0;
    ck_assert_uint_eq(hatch_plan_nearest(four, 4, &limits), 0);
    ck_assert(isinf(hatch_plan_excess(&four[1], &limits, &worst)));
    ck_assert_str_eq(worst.name, "mb");
    ck_assert_double_eq_tol(worst.value, 2, 1e-12);
}
END_TEST

/* Times within 3 % of the least are equal; then bytes decide, then the set-up, then the order. */
START_TEST(ties_go_to_the_smaller_files)
{
    struct hatch_plan_figures limits = hatch_plan_no_limits(), tied[] = {{100, 5e6, 1, 0.01},
                                                                         {102.9, 4e6, 3, 0.01},
                                                                         {102.9, 4e6, 2, 0.01},
                                                                         {102.9, 4e6, 2, 0.01},
                                                                         {103.1, 1, 0, 0.01}};
    limits.error = 0.02;
    ck_assert_uint_eq(hatch_plan_choose(tied, 5, &limits), 2);
    ck_assert_uint_eq(hatch_plan_choose(tied, 2, &limits), 1);
    ck_assert_uint_eq(hatch_plan_choose(tied + 2, 2, &limits), 0);
    limits.error = INFINITY;
    limits.ms = 110;
    ck_assert_uint_eq(hatch_plan_choose(tied, 5, &limits), 4);
}
END_TEST

static Suite *suite(void)
{
    Suite *suite = suite_create("plan");
    TCase *tests = tcase_create("plan");
    tcase_add_test(tests, a_budget_sets_what_it_names);
    tcase_add_test(tests, other_budgets_are_refused_and_change_nothing);
    tcase_add_test(tests, the_worst_figure_is_the_excess);
    tcase_add_test(tests, the_front_leaves_out_what_another_one_covers);
    tcase_add_test(tests, no_figure_is_left_out_of_the_front);
    tcase_add_test(tests, with_a_tolerance_the_fastest_is_chosen);
    tcase_add_test(tests, with_a_budget_alone_the_most_exact_is_chosen);
    tcase_add_test(tests, over_a_limit_of_0_the_least_figure_is_nearest);
    tcase_add_test(tests, ties_go_to_the_smaller_files);
    suite_add_tcase(suite, tests);
    return suite;
}
HATCH_TEST_MAIN(suite)
