#include <math.h>

#include "math/percentile.h"
#include "run.h"

static const double quartiles[] = {0.25, 0.5, 0.75};

START_TEST(values_are_ranked_by_weight)
{
    struct hatch_weighted values[] = {{7, 1}, {1, 2}, {9, 4}, {3, 1}};
    double out[3];
    hatch_percentiles(values, 4, quartiles, 3, out);
    ck_assert_double_eq(out[0], 1); /* 2 of 8 */
    ck_assert_double_eq(out[1], 7); /* 2, 3, 4 of 8 */
    ck_assert_double_eq(out[2], 9);
}
END_TEST

START_TEST(the_ends_are_the_smallest_and_the_largest)
{
    static const double ends[] = {0, 1};
    struct hatch_weighted values[] = {{0.3, 0.1}, {0.1, 0.1}, {0.2, 0.7}};
    double out[2];
    hatch_percentiles(values, 3, ends, 2, out);
    ck_assert_double_eq(out[0], 0.1);
    ck_assert_double_eq(out[1], 0.3);
}
END_TEST

START_TEST(percentiles_of_no_values_are_nan)
{
    double out[3] = {1, 2, 3};
    hatch_percentiles(NULL, 0, quartiles, 3, out);
    for (int i = 0; i < 3; i++)
        ck_assert(isnan(out[i]));
}
END_TEST

static Suite *suite(void)
{
    Suite *made = suite_create("math percentile");
    TCase *tests = tcase_create("percentile");
    tcase_add_test(tests, values_are_ranked_by_weight);
    tcase_add_test(tests, the_ends_are_the_smallest_and_the_largest);
    tcase_add_test(tests, percentiles_of_no_values_are_nan);
    suite_add_tcase(made, tests);
    return made;
}

HATCH_TEST_MAIN(suite)
